vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.34;
  float t1 = (position.y * -0.5 + 0.5) * bend;
  float t2 = bend * -0.5;
  float t3 = position.x * 0.1156;
  float t4 = (t3 + t3) * 1.6;
  float t5 = 1.5 / bend;
  float t6 = t5 - (position.z * 0.04 - t0 * t0 * 1.6);
  float t7 = sin(t1);
  float t8 = t7 * t4;
  float t9 = t7 * -0.04;
  float t10 = cos(t1);
  float t11 = t6 * (t10 * t2);
  float t12 = t10 * t4;
  float t13 = t6 * (t7 * t2);
  float t14 = t10 * -0.04;
  float t15 = (t11 * t14 + t13 * t9) * normal.x + (t9 * t12 - t14 * t8) * normal.y + (-t8 * t13 - t12 * t11) * normal.z;
  float t16 = t10 * 0.0136 * normal.y - t13 * 0.34 * normal.z;
  float t17 = t11 * -0.34 * normal.z - t7 * 0.0136 * normal.y;
  float t18 = t15 * t15 + t16 * t16 + t17 * t17;
  float t19 = t18 > 0.0 ? inversesqrt(t18) : 0.0;
  offset = vec3(t0 - position.x, -t7 * t6 - position.y, t5 - t10 * t6 - position.z);
  warpedPosition = position + offset;
  warpedNormal = vec3(t15 * t19, t16 * t19, t17 * t19);
}
