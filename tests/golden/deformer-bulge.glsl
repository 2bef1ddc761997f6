vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = (position.x - (fract(millis / 3000.0) - 0.5) * 800.0) / 110.0;
  float t1 = t0 * t0;
  float t2 = t0 * 0.009090909;
  float t3 = min(t1, 1.0);
  float t4 = 1.0 - t3;
  float t5 = t3 - 1.0;
  float t6 = t4 * t4;
  float t7 = (t4 * (t5 + t5) - t6) * 1.4;
  float t8 = t7 * (1.0 < t1 ? 0.0 : t2 + t2);
  float t9 = t4 * t6 * 1.4;
  float t10 = t9 + 1.0;
  float t11 = t10 * t10 * normal.x - t10 * (position.y * t8) * normal.y - position.z * t8 * t10 * normal.z;
  offset = vec3(0.0, position.y * t9, position.z * t9);
  float t12 = t10 * normal.y;
  float t13 = t10 * normal.z;
  float t14 = t11 * t11 + t12 * t12 + t13 * t13;
  float t15 = t14 > 0.0 ? inversesqrt(t14) : 0.0;
  warpedNormal = vec3(t11 * t15, t12 * t15, t13 * t15);
  warpedPosition = position + offset;
}
