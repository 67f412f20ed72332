import * as THREE from 'three';
import {
  brightMap,
  colourMap,
  cubeMap,
  equirect,
  greyMap,
  holes,
  normalMap,
  objectNormalMap,
} from '../matrix/textures';
import type { Kind, MaterialFacts } from './SceneFacts';

function changed(texture: THREE.DataTexture, change: (texture: THREE.DataTexture) => void): THREE.DataTexture {
  change(texture);
  return texture;
}

function steps(): THREE.DataTexture {
  const texture = new THREE.DataTexture(new Uint8Array([60, 120, 180, 255]), 4, 1, THREE.RedFormat);
  texture.needsUpdate = true;
  return texture;
}

const makers: Readonly<Record<string, () => THREE.Texture>> = {
  colour: colourMap,
  'colour turned': () =>
    changed(colourMap(), (map) => {
      map.repeat.set(2, 3);
      map.offset.set(0.2, 0.1);
      map.rotation = 0.5;
    }),
  'colour nearest': () =>
    changed(colourMap(), (map) => {
      map.magFilter = THREE.NearestFilter;
      map.wrapS = THREE.MirroredRepeatWrapping;
      map.repeat.set(3, 1);
    }),
  'colour uv1': () => changed(colourMap(), (map) => (map.channel = 1)),
  bright: brightMap,
  grey: greyMap,
  holes,
  normal: normalMap,
  'object normal': objectNormalMap,
  cube: cubeMap,
  'cube refracted': () => {
    const map = cubeMap();
    map.mapping = THREE.CubeRefractionMapping;
    return map;
  },
  equirect,
  steps,
  checker: () => {
    const bytes = Uint8Array.from({ length: 64 * 64 * 4 }, (_, i) => (((i >> 2) ^ (i >> 8)) & 4 ? 255 : 40));
    const texture = new THREE.DataTexture(bytes, 64, 64);
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.generateMipmaps = true;
    texture.minFilter = THREE.LinearMipmapLinearFilter;
    texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
  },
};

const textures = new Map<string, THREE.Texture>();

/** A texture by name, one for the whole page. */
export function textureOf(name: string): THREE.Texture {
  let texture = textures.get(name);
  if (texture === undefined) {
    if (!(name in makers)) throw new Error(`No texture "${name}": there are ${Object.keys(makers).join(', ')}.`);
    texture = makers[name]();
    textures.set(name, texture);
  }
  return texture;
}

/** Changes of shaders by `onBeforeCompile`: [chunk of the vertex or fragment shader, GLSL after it]. */
const compiles: Readonly<Record<string, readonly ['vertexShader' | 'fragmentShader', string, string]>> = {
  waves: ['vertexShader', 'begin_vertex', 'transformed += 0.08 * sin(position.yzx * 9.0);'],
  tint: [
    'fragmentShader',
    'dithering_fragment',
    'gl_FragColor.rgb = mix(sqrt(gl_FragColor.rgb), vec3(0.9, 0.2, 0.1), 0.3);',
  ],
  stripes: ['fragmentShader', 'dithering_fragment', 'if (fract(gl_FragCoord.x / 6.0) < 0.4) discard;'],
};

const shaders: Readonly<Record<string, () => THREE.ShaderMaterial>> = {
  'unlit shader': () =>
    new THREE.ShaderMaterial({
      vertexShader:
        'varying vec3 n; void main() { n = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
      fragmentShader:
        'varying vec3 n; void main() { gl_FragColor = vec4(vec3(0.2, 0.6, 0.8) * (0.5 + 0.5 * n.z), 0.7); }',
    }),
  'raw shader': () =>
    new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader:
        'in vec3 position; uniform mat4 projectionMatrix, modelViewMatrix; out vec3 p; void main() { p = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
      fragmentShader:
        'precision highp float; in vec3 p; out vec4 colour; void main() { colour = vec4(abs(p) * 0.6, 1.0); }',
    }),
};

type Parameters = Record<string, unknown>;

/** The value that three takes for a fact: textures for names, vectors and colours for numbers. */
function valueOf(name: string, value: unknown): unknown {
  if (typeof value === 'string') return textureOf(value);
  if (name === 'normalScale') return new THREE.Vector2().fromArray(value as number[]);
  if (name === 'envMapRotation') return new THREE.Euler().fromArray(value as [number, number, number]);
  if (name === 'clippingPlanes')
    return (value as readonly number[][]).map(
      ([x, y, z, constant]) => new THREE.Plane(new THREE.Vector3(x, y, z + 1e-3).normalize(), constant),
    );
  return value;
}

const defaultTypes: Readonly<Partial<Record<Kind, string>>> = {
  points: 'PointsMaterial',
  sprite: 'SpriteMaterial',
  line: 'LineBasicMaterial',
  loop: 'LineBasicMaterial',
  segments: 'LineBasicMaterial',
};

/** Makes the material that facts describe, for a kind of object: a Lambert material where meshes' name no type. */
export function buildMaterial({ type, compile, ...facts }: MaterialFacts, kind: Kind): THREE.Material {
  type ??= defaultTypes[kind] ?? 'MeshLambertMaterial';
  const parameters: Parameters = {};
  for (const [name, value] of Object.entries(facts)) parameters[name] = valueOf(name, value);
  if (type in shaders) {
    const material = shaders[type]();
    delete parameters.color;
    for (const name of Object.keys(parameters)) if (!(name in material)) delete parameters[name];
    material.setValues(parameters);
    return material;
  }
  const Class = (THREE as unknown as Record<string, new () => THREE.Material>)[type];
  const material = new Class();
  // facts of one type may meet another where a scene is shrunk
  for (const name of Object.keys(parameters)) if (!(name in material)) delete parameters[name];
  material.setValues(parameters as THREE.MaterialParameters);
  if (typeof compile === 'string') {
    const [stage, chunk, text] = compiles[compile];
    material.onBeforeCompile = (shader) => {
      shader[stage] = shader[stage].replace(`#include <${chunk}>`, `#include <${chunk}>\n${text}`);
    };
    material.customProgramCacheKey = () => compile;
  }
  return material;
}
