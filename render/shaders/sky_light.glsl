uniform vec3 skyLight, groundLight, sunLight;

vec3 ambient(vec3 normal) { return mix(groundLight, skyLight, 0.5 + 0.5 * normal.y); }
