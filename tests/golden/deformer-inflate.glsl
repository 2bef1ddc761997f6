vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
  float t1 = t0 > 0.0 ? inversesqrt(t0) : 0.0;
  float t2 = position.y / 16.0 - millis / 300.0;
  float t3 = normal.y * t1;
  float t4 = cos(t2) * 0.25;
  float t5 = sin(t2) * 4.0 + 2.0;
  float t6 = normal.x * t1;
  float t7 = normal.z * t1;
  offset = vec3(t6 * t5, t3 * t5, t7 * t5);
  float t8 = normal.y - t6 * t4 * normal.x - t7 * t4 * normal.z;
  float t9 = t3 * t4 + 1.0;
  float t10 = t9 * normal.x;
  float t11 = t9 * normal.z;
  float t12 = t10 * t10 + t8 * t8 + t11 * t11;
  float t13 = t12 > 0.0 ? inversesqrt(t12) : 0.0;
  warpedNormal = vec3(t10 * t13, t8 * t13, t11 * t13);
  warpedPosition = position + offset;
}
