vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = (position.x - (fract(millis / 3000.0) - 0.5) * 800.0) / 110.0;
  float t1 = t0 * t0;
  float t2 = min(t1, 1.0);
  float t3 = 1.0 - t2;
  float t4 = t3 * t3;
  float t5 = (t3 * ((t2 - 1.0) * 2.0) - t4) * 1.4;
  float t6 = t5 * (1.0 < t1 ? 0.0 : t0 * 0.018181818);
  float t7 = t3 * t4 * 1.4;
  float t8 = t7 + 1.0;
  vec3 t9 = vec3(t8 * t8 * normal.x - t8 * (position.y * t6) * normal.y - position.z * t6 * t8 * normal.z, t8 * normal.y, t8 * normal.z);
  offset = vec3(0.0, position.y * t7, position.z * t7);
  float t10 = dot(t9, t9);
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  warpedNormal = t9 * t11;
  warpedPosition = position + offset;
}
