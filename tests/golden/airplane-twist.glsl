vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1200.0);
  float t1 = t0 * position.x * 0.015;
  float t2 = t0 * 0.015;
  float t3 = sin(t1);
  float t4 = cos(t1);
  float t5 = t4 * t2;
  float t6 = t3 * t2;
  float t7 = -position.y * t6 - position.z * t5;
  float t8 = position.y * t5 - position.z * t6;
  float t9 = (t4 * t4 + t3 * t3) * normal.x + (-t3 * t8 - t4 * t7) * normal.y + (t7 * t3 - t8 * t4) * normal.z;
  float t10 = t4 * normal.y - t3 * normal.z;
  float t11 = t3 * normal.y + t4 * normal.z;
  offset = vec3(0.0, position.y * t4 - position.z * t3 - position.y, position.y * t3 + position.z * t4 - position.z);
  float t12 = t9 * t9 + t10 * t10 + t11 * t11;
  float t13 = t12 > 0.0 ? inversesqrt(t12) : 0.0;
  warpedNormal = vec3(t9 * t13, t10 * t13, t11 * t13);
  warpedPosition = position + offset;
}
