vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1000.0) * -0.9 / 160.0;
  float t1 = -t0 * (position.y - 60.0);
  float t2 = -t0;
  float t3 = t1 < -1.0 ? 0.0 : t2;
  float t4 = max(t1, -1.0);
  float t5 = t4 + 1.0;
  vec3 t6 = vec3(t5 * normal.x, t5 * t5 * normal.y - position.x * t3 * t5 * normal.x - t5 * (position.z * t3) * normal.z, t5 * normal.z);
  offset = vec3(position.x * t4, 0.0, position.z * t4);
  float t7 = dot(t6, t6);
  vec3 t8 = t6 * inversesqrt(t7);
  warpedNormal = t7 > 0.0 && t7 < 1e38 ? t8 : vec3(0.0);
  warpedPosition = position + offset;
}
