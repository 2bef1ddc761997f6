vec3 offset, warpedPosition, warpedNormal;
{
  vec3 t0 = position.yzx * vec3(20.0, 10.0, 15.0) + millis * vec3(0.002, 0.0005, 0.0015);
  float t1 = cos(t0.z) * 0.75;
  float t2 = cos(t0.x);
  float t3 = cos(t0.y) * 0.5;
  vec3 t4 = vec3(normal.x + t3 * t1 * normal.y - t1 * normal.z, normal.y - t2 * normal.x + t1 * t2 * normal.z, t2 * t3 * normal.x - t3 * normal.y + normal.z);
  offset = sin(t0) * 0.05;
  float t5 = dot(t4, t4);
  float t6 = inversesqrt(t5);
  warpedNormal = t4 * (t5 > 0.0 ? t6 : 0.0);
  warpedPosition = position + offset;
}
