vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = (position.x - (fract(millis / 3000.0) - 0.5) * 800.0) / 110.0;
  float t1 = t0 * t0;
  float t2 = t0 * 0.018181818;
  float t3 = 1.0 - min(t1, 1.0);
  float t4 = t3 * t3;
  float t5 = (t3 * (-t3 - t3) - t4) * 1.4 * (1.0 < t1 ? 0.0 : t2);
  float t6 = t3 * t4 * 1.4;
  float t7 = t6 + 1.0;
  vec3 t8 = vec3(t7 * t7 * normal.x - t7 * (position.y * t5) * normal.y - position.z * t5 * t7 * normal.z, t7 * normal.y, t7 * normal.z);
  offset = vec3(0.0, position.y * t6, position.z * t6);
  float t9 = dot(t8, t8);
  vec3 t10 = t8 * inversesqrt(t9);
  warpedNormal = t9 > 0.0 && t9 < 1e38 ? t10 : vec3(0.0);
  warpedPosition = position + offset;
}
