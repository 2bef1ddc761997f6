vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = cos(millis / 1500.0) * 2.6 / 150.0;
  float t1 = t0 * position.y;
  float t2 = cos(t1);
  float t3 = sin(t1);
  float t4 = position.x + 25.0;
  float t5 = t3 * t0;
  float t6 = t2 * t0;
  float t7 = position.z * t6 - t4 * t5;
  float t8 = -position.z * t5 - t4 * t6;
  float t9 = (t8 * t3 - t7 * t2) * normal.x + (t2 * t2 + t3 * t3) * normal.y + (-t3 * t7 - t2 * t8) * normal.z;
  float t10 = t2 * normal.x + t3 * normal.z;
  float t11 = t2 * normal.z - t3 * normal.x;
  float t12 = t2 - 1.0;
  offset = vec3(t4 * t12 + position.z * t3, 0.0, position.z * t12 - t4 * t3);
  float t13 = t10 * t10 + t9 * t9 + t11 * t11;
  float t14 = t13 > 0.0 ? inversesqrt(t13) : 0.0;
  warpedNormal = vec3(t10 * t14, t9 * t14, t11 * t14);
  warpedPosition = position + offset;
}
