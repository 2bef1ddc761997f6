vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = (position.x - (fract(millis / 3000.0) - 0.5) * 800.0) / 110.0;
  float t1 = t0 * t0;
  float t2 = 1.0 - min(t1, 1.0);
  float t3 = t2 * t2;
  float t4 = (t2 * (-t2 - t2) - t3) * 1.4 * (1.0 < t1 ? 0.0 : t0 * 0.018181818);
  float t5 = t2 * t3 * 1.4;
  float t6 = t5 + 1.0;
  vec3 t7 = vec3(t6 * t6 * normal.x - t6 * (position.y * t4) * normal.y - position.z * t4 * t6 * normal.z, t6 * normal.y, t6 * normal.z);
  offset = vec3(0.0, position.y * t5, position.z * t5);
  float t8 = dot(t7, t7);
  warpedNormal = t7 * (t8 > 0.0 ? inversesqrt(t8) : 0.0);
  warpedPosition = position + offset;
}
