vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = cos(millis / 1500.0) * 2.6 / 150.0;
  float t1 = t0 * position.y;
  float t2 = cos(t1);
  float t3 = sin(t1);
  float t4 = position.x + 25.0;
  float t5 = t3 * t0;
  float t6 = t2 * t0;
  float t7 = position.z * t6 - t4 * t5;
  float t8 = -position.z * t5 - t4 * t6;
  vec3 t9 = vec3(t2 * normal.x + t3 * normal.z, (t8 * t3 - t7 * t2) * normal.x + normal.y + (-t3 * t7 - t2 * t8) * normal.z, t2 * normal.z - t3 * normal.x);
  float t10 = t2 - 1.0;
  offset = vec3(t4 * t10 + position.z * t3, 0.0, position.z * t10 - t4 * t3);
  float t11 = dot(t9, t9);
  float t12 = inversesqrt(t11);
  warpedNormal = t9 * (t11 > 0.0 ? t12 : 0.0);
  warpedPosition = position + offset;
}
