out vec4 coverage;

void main() { coverage = vec4(1.0); }
