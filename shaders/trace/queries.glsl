// The number of queries that an invocation has made; counted by trace/portions.glsl only.
uint queries = 0u;
