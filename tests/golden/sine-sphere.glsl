vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 700.0;
  float t1 = position.y * 7.0 + t0;
  float t2 = position.z * 7.0 + t0 + 2.0;
  float t3 = position.x * 7.0 + t0 + 4.0;
  float t4 = cos(t3) * 0.91;
  offset = vec3(sin(t1) * 0.13, sin(t2) * 0.13, sin(t3) * 0.13);
  float t5 = cos(t1) * 0.91;
  float t6 = cos(t2) * 0.91;
  float t7 = normal.x + t6 * t4 * normal.y - t4 * normal.z;
  float t8 = normal.y - t5 * normal.x + t4 * t5 * normal.z;
  float t9 = t5 * t6 * normal.x - t6 * normal.y + normal.z;
  float t10 = t7 * t7 + t8 * t8 + t9 * t9;
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  warpedNormal = vec3(t7 * t11, t8 * t11, t9 * t11);
  warpedPosition = position + offset;
}
