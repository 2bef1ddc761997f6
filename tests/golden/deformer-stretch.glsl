vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = max(sin(millis / 350.0) * 0.45 + 1.0, 0.01);
  float t1 = inversesqrt(t0);
  float t2 = t0 * t1;
  vec3 t3 = vec3(t2, t1 * t1, t2) * normal;
  float t4 = t1 - 1.0;
  offset = vec3(position.x * t4, (position.y - 100.0) * (t0 - 1.0), position.z * t4);
  float t5 = dot(t3, t3);
  float t6 = inversesqrt(t5);
  warpedNormal = t3 * (t5 > 0.0 ? t6 : 0.0);
  warpedPosition = position + offset;
}
