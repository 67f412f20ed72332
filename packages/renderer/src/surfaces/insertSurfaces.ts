import type { ShaderChunk } from 'three';
import type { TwinShader } from '../materials/TwinKind';
import type { MicroShaderRegistry } from '../microshaders';
import { findChunk } from '../three/replaceChunk';
import type { Surface } from './Surface';

type ChunkName = keyof typeof ShaderChunk;

const MAIN = /\bvoid\s+main\s*\(/;
const STRUCTURES = /^\/\/ <surfaceData>\n[^]*?^\/\/ <\/surfaceData>\n/m;

/** Tests whether a surface's text uses a member of SurfaceData or VertexData. */
type Names = (member: string) => boolean;

/**
 * Inserts surfaces in a shader of three's: lit, unlit, or one that writes depths for shadow maps. Pixel hooks run after all
 * maps, before lighting and alpha tests; vertex hooks after morphs, before skinning. Only members that the surfaces use are
 * computed.
 */
export function insertSurfaces(shader: TwinShader, surfaces: readonly Surface[], registry: MicroShaderRegistry): void {
  const painting = surfaces.filter(({ parsed }) => parsed.paints);
  const displacing = surfaces.filter(({ parsed }) => parsed.displaces);
  const headers = registry.header(painting.map(({ chunk }) => chunk));
  const text = headers.replace(STRUCTURES, '');
  const names: Names = (member) => new RegExp(`\\.\\s*${member}\\b`).test(text);
  const varyings = painting.length > 0 ? insertPixels(shader, painting, headers, names) : [];
  insertVertices(shader, displacing, registry, varyings);
}

/** Adds the pixel hooks. @returns the varyings that they need */
function insertPixels(shader: TwinShader, surfaces: readonly Surface[], headers: string, names: Names): string[] {
  let text = shader.fragmentShader;
  const has = (chunk: ChunkName) => findChunk(text, chunk) !== null;
  const hasNormal = has('normal_fragment_begin');
  const hasView = /\bvarying\s+vec3\s+vViewPosition\b/.test(text);
  const isLit = text.includes('totalEmissiveRadiance');
  // shaders that write depths or distances have no colour output
  const isUnlit = !isLit && has('opaque_fragment');
  const varyings: string[] = [];
  const varying = (name: string) => {
    varyings.push(name);
    return `farol_${name}`;
  };
  const lines: string[] = ['SurfaceData farol_surface;'];
  const set = (member: string, value: string, other: string) =>
    lines.push(`farol_surface.${member} = ${names(member) ? value : other};`);
  const needsView = names('positionVS') || names('viewDirectionVS');
  const positionVS = hasView ? '-vViewPosition' : needsView ? varying('positionVS') : '';
  const zero = 'vec3(0.0)';
  set('positionOS', names('positionOS') ? varying('positionOS') : '', zero);
  set('positionWS', names('positionWS') ? varying('positionWS') : '', zero);
  set('positionVS', positionVS, zero);
  set('normalOS', names('normalOS') ? varying('normalOS') : '', zero);
  const namesNormal = names('normalVS') || names('normalWS');
  // unlit shaders have no normal
  const normalVS = hasNormal ? 'normal' : namesNormal ? `normalize(${varying('normalVS')})` : zero;
  set('normalVS', normalVS, zero);
  set('normalWS', `normalize((vec4(${normalVS}, 0.0) * viewMatrix).xyz)`, zero);
  set('viewDirectionVS', `isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-(${positionVS}))`, zero);
  set('uv', names('uv') ? varying('uv') : '', 'vec2(0.0)');
  lines.push('farol_surface.frontFacing = gl_FrontFacing;');
  lines.push('farol_surface.color = diffuseColor.rgb;', 'farol_surface.opacity = diffuseColor.a;');
  const hasRoughness = has('roughnessmap_fragment');
  lines.push(`farol_surface.roughness = ${hasRoughness ? 'roughnessFactor' : '1.0'};`);
  lines.push(`farol_surface.metalness = ${hasRoughness ? 'metalnessFactor' : '0.0'};`);
  lines.push(`farol_surface.emissive = ${isLit ? 'totalEmissiveRadiance' : zero};`);
  for (const { prefix } of surfaces)
    lines.push(`farol_surface.time = ${prefix}time;`, `${prefix}surface(farol_surface);`);
  if (names('color')) lines.push('diffuseColor.rgb = farol_surface.color;');
  if (names('opacity')) lines.push('diffuseColor.a = farol_surface.opacity;');
  if (names('normalVS') && hasNormal) lines.push('normal = farol_surface.normalVS;');
  if (names('roughness') && hasRoughness) lines.push('roughnessFactor = farol_surface.roughness;');
  if (names('metalness') && hasRoughness) lines.push('metalnessFactor = farol_surface.metalness;');
  if (names('emissive') && isLit) lines.push('totalEmissiveRadiance = farol_surface.emissive;');
  if (names('emissive') && isUnlit) lines.push('diffuseColor.rgb += farol_surface.emissive;');

  // alpha tests are moved after the code that may change alpha
  let tests = '';
  for (const name of ['alphatest_fragment', 'alphahash_fragment'] as const) {
    const found = findChunk(text, name);
    if (found === null) continue;
    tests += `${found}\n`;
    text = text.replace(found, name === 'alphahash_fragment' ? '// alpha\n' : '');
  }
  const place = (['emissivemap_fragment', 'normal_fragment_maps'] as const)
    .map((name) => findChunk(text, name))
    .find((found) => found !== null);
  const anchor = place ?? '// alpha\n';
  text = text.replace(anchor, (found) => `${found}\n${lines.join('\n')}\n${tests}`);
  const uniforms = surfaces.map(({ prefix }) => `uniform float ${prefix}time;\n`).join('');
  shader.fragmentShader = text.replace(
    MAIN,
    (main) => `${declared(varyings)}#define FAROL_FRAGMENT_STAGE\n${headers}${uniforms}${main}`,
  );
  return varyings;
}

const declared = (varyings: readonly string[]) =>
  varyings.map((name) => `varying ${name === 'uv' ? 'vec2' : 'vec3'} farol_${name};\n`).join('');

function insertVertices(
  shader: TwinShader,
  surfaces: readonly Surface[],
  registry: MicroShaderRegistry,
  varyings: readonly string[],
): void {
  const displaces = surfaces.length > 0;
  if (!displaces && varyings.length === 0) return;
  let text = shader.vertexShader;
  const take = (name: ChunkName) => {
    const found = findChunk(text, name)!;
    text = text.replace(found, '');
    return found;
  };
  const after = (name: ChunkName, statements: string) => {
    const found = findChunk(text, name)!;
    text = text.replace(found, () => `${found}\n${statements}`);
  };
  const wants = (name: string) => varyings.includes(name);
  // lit shaders transform normals before positions; other shaders may have no normals
  const hasNormals = findChunk(text, 'normal_vertex') !== null;
  const normal = hasNormals ? 'objectNormal' : 'vec3(normal)';
  let hook = '';
  if (displaces) {
    hook += `VertexData farol_vertex = VertexData(transformed, ${normal}, uv, 0.0);\n`;
    for (const { prefix } of surfaces) hook += `farol_vertex.time = ${prefix}time;\n${prefix}displace(farol_vertex);\n`;
    hook += 'transformed = farol_vertex.positionOS;\n';
    if (hasNormals) hook += 'objectNormal = farol_vertex.normalOS;\n';
  }
  if (wants('normalVS')) hook += `vec3 farol_normal = ${displaces ? 'farol_vertex.normalOS' : normal};\n`;
  if (wants('normalOS')) hook += `farol_normalOS = ${displaces ? 'farol_vertex.normalOS' : normal};\n`;
  if (wants('positionOS')) hook += 'farol_positionOS = vec3(position);\n';
  if (wants('uv')) hook += 'farol_uv = uv;\n';
  if (hasNormals) {
    const positions = `${take('begin_vertex')}\n${take('morphtarget_vertex')}\n`;
    after('morphnormal_vertex', `${positions}${hook}`);
  } else after('morphtarget_vertex', hook);
  let placed = wants('positionVS') ? 'farol_positionVS = mvPosition.xyz;\n' : '';
  if (wants('positionWS')) placed += WORLD;
  if (wants('normalVS')) placed += NORMAL;
  if (placed) after('project_vertex', placed);
  let header = declared(varyings);
  if (displaces) {
    header += registry.header(surfaces.map(({ vertexChunk }) => vertexChunk));
    for (const { prefix } of surfaces) header += `uniform float ${prefix}time;\nuniform float ${prefix}timeBefore;\n`;
    const before = surfaces.map(({ prefix }) => `(v).time = ${prefix}timeBefore; ${prefix}displace(v);`).join(' ');
    header += `#define FAROL_DISPLACE_BEFORE(v) ${before}\n`;
  }
  shader.vertexShader = text.replace(MAIN, (main) => `${header}${main}`);
}

const WORLD = `vec4 farol_world = vec4(transformed, 1.0);
#ifdef USE_BATCHING
farol_world = batchingMatrix * farol_world;
#endif
#ifdef USE_INSTANCING
farol_world = instanceMatrix * farol_world;
#endif
farol_positionWS = (modelMatrix * farol_world).xyz;
`;

/** GLSL that computes normals like three's chunks, for shaders without these. */
const NORMAL = `#ifdef USE_SKINNING
mat4 farol_skin = skinWeight.x * boneMatX + skinWeight.y * boneMatY + skinWeight.z * boneMatZ + skinWeight.w * boneMatW;
farol_normal = (bindMatrixInverse * farol_skin * bindMatrix * vec4(farol_normal, 0.0)).xyz;
#endif
#ifdef USE_BATCHING
mat3 farol_batch = mat3(batchingMatrix);
farol_normal /= vec3(dot(farol_batch[0], farol_batch[0]), dot(farol_batch[1], farol_batch[1]),
  dot(farol_batch[2], farol_batch[2]));
farol_normal = farol_batch * farol_normal;
#endif
#ifdef USE_INSTANCING
mat3 farol_instance = mat3(instanceMatrix);
farol_normal /= vec3(dot(farol_instance[0], farol_instance[0]), dot(farol_instance[1], farol_instance[1]),
  dot(farol_instance[2], farol_instance[2]));
farol_normal = farol_instance * farol_normal;
#endif
farol_normalVS = normalMatrix * farol_normal;
`;
