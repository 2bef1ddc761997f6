vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = 100.0 - position.y;
  float t1 = t0 / 60.0;
  float t2 = sin(millis / 1400.0) * 0.42 + 0.42;
  float t3 = exp(-t1 * t1);
  float t4 = t1 * -0.016666668;
  float t5 = t2 * (t3 * (t4 + t4));
  float t6 = t3 * t2;
  offset = vec3(position.x * t6, t0 * t2, position.z * t6);
  float t7 = t6 + 1.0;
  float t8 = (1.0 - t2) * t7;
  float t9 = position.x * t5 * t7 * normal.x + t7 * t7 * normal.y + t7 * (position.z * t5) * normal.z;
  float t10 = t8 * normal.x;
  float t11 = t8 * normal.z;
  float t12 = t10 * t10 + t9 * t9 + t11 * t11;
  float t13 = t12 > 0.0 ? inversesqrt(t12) : 0.0;
  warpedNormal = vec3(t10 * t13, t9 * t13, t11 * t13);
  warpedPosition = position + offset;
}
