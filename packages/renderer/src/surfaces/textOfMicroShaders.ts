import { dependencyOrder } from '../microshaders/dependencyOrder';
import type { MicroShader } from '../microshaders/MicroShader';

/** GLSL of a surface's data for each varying of the thesis's chunks. */
const VARYINGS: Readonly<Record<string, string>> = {
  positionWS: 's.positionWS',
  normalWS: 's.normalWS',
  textureCoordinate: 's.uv',
};
const VARYING_LINE = /^[ \t]*varying[ \t]+(?:(?:high|medium|low)p[ \t]+)?(\w+)[ \t]+(\w+)[ \t]*;.*$/;

/**
 * Text of a surface that draws the colour of fragment microshaders, such as the thesis's Phong material under one light:
 * `['surface', 'light', 'light_point', 'phong', 'phong_output']` of `microshaders/thesis.xml`. Their `gl_FragColor` becomes the
 * only emitted light: use it on a MeshBasicMaterial, or a black one. Their uniforms are the surface's.
 * @param chunks - all chunks; they may read the varyings positionWS, normalWS and textureCoordinate
 * @param names - names of the chunks whose main parts form the fragment shader, in this order
 * @throws Error for an unknown chunk or varying
 * @see thesis 3.1.2
 */
export function textOfMicroShaders(chunks: readonly MicroShader[], names: readonly string[]): string {
  const byName = new Map(chunks.map((chunk) => [chunk.name, chunk]));
  const source = { get: (name: string) => byName.get(name), names: () => [...byName.keys()] };
  const varyings = new Set<string>();
  const headers = dependencyOrder(names, source).flatMap(({ name, header }) => {
    const lines = header.split('\n').map((line) => {
      const match = VARYING_LINE.exec(line);
      if (match === null) return line;
      const [, type, varying] = match;
      if (!Object.hasOwn(VARYINGS, varying))
        throw new Error(
          `Microshader "${name}" reads the varying "${varying}", which surfaces do not have; use one of: ${Object.keys(VARYINGS).join(', ')}.`,
        );
      varyings.add(varying);
      return `${type} ${varying};`;
    });
    return [`// ${name}`, ...lines.filter((line) => line.trim() !== '')];
  });
  const mains = names.map((name) =>
    byName
      .get(name)!
      .main.trim()
      .replaceAll(/\bgl_FragColor\b/g, 'drawnColor'),
  );
  return `${headers.join('\n')}

void surface(inout SurfaceData s) {
${[...varyings].map((name) => `${name} = ${VARYINGS[name]};\n`).join('')}vec4 drawnColor = vec4(0.0, 0.0, 0.0, 1.0);
${mains.filter(Boolean).join('\n')}
s.color = vec3(0.0);
s.emissive = drawnColor.rgb;
s.opacity = drawnColor.a;
}
`;
}
