vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1200.0);
  float t1 = t0 * position.x * 0.015;
  float t2 = t0 * 0.015;
  float t3 = sin(t1);
  float t4 = cos(t1);
  vec3 t5 = vec3(normal.x + position.z * t2 * normal.y - position.y * t2 * normal.z, t4 * normal.y - t3 * normal.z, t3 * normal.y + t4 * normal.z);
  offset = vec3(0.0, position.y * t4 - position.z * t3 - position.y, position.y * t3 + position.z * t4 - position.z);
  float t6 = dot(t5, t5);
  float t7 = inversesqrt(t6);
  warpedNormal = t5 * (t6 > 0.0 ? t7 : 0.0);
  warpedPosition = position + offset;
}
