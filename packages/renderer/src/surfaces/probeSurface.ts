import type { MicroShader } from '../microshaders/MicroShader';
import type { MicroShaderRegistry } from '../microshaders';
import type { MicroShaderSource } from '../microshaders/dependencyOrder';
import { composeHeaders } from '../microshaders/composeSource';
import { WebGLShaderCompiler } from '../microshaders/WebGLShaderCompiler';

/** Declarations that precede a surface's code in three's shaders. */
const GIVEN = {
  vertex: `#include <common>
attribute vec3 position;
attribute vec3 normal;
attribute vec2 uv;
uniform mat4 modelMatrix;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
uniform mat3 normalMatrix;
uniform vec3 cameraPosition;
uniform bool isOrthographic;
`,
  fragment: `#define FAROL_FRAGMENT_STAGE
#include <common>
uniform mat4 viewMatrix;
uniform vec3 cameraPosition;
uniform bool isOrthographic;
`,
};

/**
 * Compiles a surface in a small separate shader, with the declarations common to three's shaders.
 * @param chunks - chunks of the surface, in place of the registry's of the same names
 * @throws MicroShaderCompileError with chunk and line; Error for an unknown include
 */
export function probeSurface(
  gl: WebGL2RenderingContext,
  registry: MicroShaderRegistry,
  chunks: readonly MicroShader[],
  prefix: string,
): void {
  const included = (chunk: MicroShader): MicroShader => ({
    ...chunk,
    dependencies: [...chunk.dependencies, ...[...chunk.header.matchAll(INCLUDE)].map((match) => match[1])],
  });
  const own = new Map(chunks.map((chunk) => [chunk.name, included(chunk)]));
  const source: MicroShaderSource = {
    get: (name) => own.get(name) ?? registry.get(name),
    names: () => registry.names(),
  };
  const [fragment, vertex] = chunks;
  const compiler = new WebGLShaderCompiler(gl);
  compiler.release(
    compiler.compile({
      name: fragment.name,
      vertexShader: `${GIVEN.vertex}${composeHeaders([vertex.name], source, 'vertex')}void main() {
VertexData v = VertexData(position, normal, uv, 0.0);
${prefix}displace(v);
gl_Position = vec4(v.positionOS + v.normalOS, 1.0);
}
`,
      fragmentShader: `${GIVEN.fragment}${composeHeaders([fragment.name], source, 'fragment')}void main() {
SurfaceData s;
${prefix}surface(s);
gl_FragColor = vec4(s.color + s.emissive + s.normalVS, s.opacity + s.roughness + s.metalness);
}
`,
    }),
  );
}

const INCLUDE = /^[ \t]*#include[ \t]+"([^"\n]*)"/gm;
