vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = 100.0 - position.y;
  float t1 = t0 / 60.0;
  float t2 = sin(millis / 1400.0) * 0.42 + 0.42;
  float t3 = exp(-t1 * t1);
  float t4 = t2 * (t3 * (t1 * -0.033333335));
  float t5 = t3 * t2;
  offset = vec3(position.x * t5, t0 * t2, position.z * t5);
  float t6 = t5 + 1.0;
  float t7 = (1.0 - t2) * t6;
  vec3 t8 = vec3(t7 * normal.x, position.x * t4 * t6 * normal.x + t6 * t6 * normal.y + t6 * (position.z * t4) * normal.z, t7 * normal.z);
  float t9 = dot(t8, t8);
  vec3 t10 = t8 * inversesqrt(t9);
  warpedNormal = t9 > 0.0 && t9 < 1e38 ? t10 : vec3(0.0);
  warpedPosition = position + offset;
}
