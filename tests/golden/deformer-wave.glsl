vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = (position.x * 0.9284767 + position.z * 0.37139067 - millis * 0.13) * 0.02617994;
  float t1 = cos(t0);
  offset = vec3(0.0, sin(t0) * 28.0, 0.0);
  float t2 = normal.x - t1 * 0.680609 * normal.y;
  float t3 = normal.z - t1 * 0.2722436 * normal.y;
  float t4 = t2 * t2 + normal.y * normal.y + t3 * t3;
  float t5 = inversesqrt(t4);
  warpedNormal = vec3(t2, normal.y, t3) * (t4 > 0.0 ? t5 : 0.0);
  warpedPosition = position + offset;
}
