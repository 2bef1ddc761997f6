vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1000.0) * -0.9 / 160.0;
  float t1 = -t0 * (position.y - 60.0);
  float t2 = t1 < -1.0 ? 0.0 : -t0;
  float t3 = max(t1, -1.0);
  float t4 = t3 + 1.0;
  vec3 t5 = vec3(t4 * normal.x, t4 * t4 * normal.y - position.x * t2 * t4 * normal.x - t4 * (position.z * t2) * normal.z, t4 * normal.z);
  offset = vec3(position.x * t3, 0.0, position.z * t3);
  float t6 = dot(t5, t5);
  warpedNormal = t5 * (t6 > 0.0 ? inversesqrt(t6) : 0.0);
  warpedPosition = position + offset;
}
