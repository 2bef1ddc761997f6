vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.05 + position.y * 0.03 + (phase - millis / 300.0);
  float t1 = position.y / 170.0 + 0.5;
  float t2 = sin(t0);
  float t3 = cos(t0);
  float t4 = t1 * -0.5882353;
  float t5 = t1 * -0.11764706 + 1.0;
  float t6 = t1 * (t3 * 0.05) * 14.0;
  float t7 = (t1 * (t3 * 0.03) + t2 * 0.005882353) * 14.0;
  vec3 t8 = vec3(t5 * normal.x - t6 * t5 * normal.z, normal.y - t4 * normal.x + (t6 * t4 - t7) * normal.z, t5 * normal.z);
  float t9 = t1 * t1 * -50.0;
  offset = vec3(t9, t9 / 5.0, t2 * t1 * 14.0);
  float t10 = dot(t8, t8);
  vec3 t11 = t8 * inversesqrt(t10);
  warpedNormal = t10 > 0.0 && t10 < 1e38 ? t11 : vec3(0.0);
  warpedPosition = position + offset;
}
