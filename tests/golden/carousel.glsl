vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y / 170.0 + 0.5;
  float t1 = position.x * 0.05 + position.y * 0.03 + (phase - millis / 300.0);
  float t2 = t0 * 0.005882353;
  float t3 = t2 + t2;
  float t4 = sin(t1);
  float t5 = cos(t1);
  float t6 = t0 * (t5 * 0.05) * 14.0;
  float t7 = (t0 * (t5 * 0.03) + t4 * 0.005882353) * 14.0;
  float t8 = t3 * -50.0;
  float t9 = normal.y - t8 * normal.x + (t6 * t8 - t7) * normal.z;
  float t10 = t3 * -10.0 + 1.0;
  float t11 = t10 * normal.x - t6 * t10 * normal.z;
  float t12 = t10 * normal.z;
  float t13 = t0 * t0 * -50.0;
  offset = vec3(t13, t13 / 5.0, t4 * t0 * 14.0);
  float t14 = t11 * t11 + t9 * t9 + t12 * t12;
  float t15 = t14 > 0.0 ? inversesqrt(t14) : 0.0;
  warpedNormal = vec3(t11 * t15, t9 * t15, t12 * t15);
  warpedPosition = position + offset;
}
