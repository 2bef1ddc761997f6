vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y / 170.0 + 0.5;
  float t1 = position.x * 0.05 + position.y * 0.03 + (phase - millis / 300.0);
  float t2 = sin(t1);
  float t3 = cos(t1);
  float t4 = t0 * (t3 * 0.05) * 14.0;
  float t5 = t0 * 0.005882353;
  float t6 = t5 + t5;
  float t7 = t0 * t0 * -50.0;
  float t8 = t6 * -50.0;
  float t9 = t6 * -10.0 + 1.0;
  float t10 = t9 * normal.z;
  float t11 = t9 * normal.x - t4 * t9 * normal.z;
  float t12 = normal.y - t8 * normal.x + (t4 * t8 - (t0 * (t3 * 0.03) + t2 * 0.005882353) * 14.0) * normal.z;
  float t13 = t11 * t11 + t12 * t12 + t10 * t10;
  float t14 = t13 > 0.0 ? inversesqrt(t13) : 0.0;
  offset = vec3(t7, t7 / 5.0, t2 * t0 * 14.0);
  warpedPosition = position + offset;
  warpedNormal = vec3(t11 * t14, t12 * t14, t10 * t14);
}
