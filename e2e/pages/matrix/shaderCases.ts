import * as THREE from 'three';
import type { Cases } from './Case';
import { colourMap } from './textures';

const ball = () => new THREE.SphereGeometry(0.6, 24, 16);

type Edit = (fragmentShader: string) => string;

/** A ball whose material's fragment shader the host edits. */
function edited(edit: Edit, material: THREE.Material = new THREE.MeshStandardMaterial({ roughness: 0.5 })): THREE.Mesh {
  material.onBeforeCompile = (shader) => void (shader.fragmentShader = edit(shader.fragmentShader));
  material.customProgramCacheKey = () => edit.toString();
  return new THREE.Mesh(ball(), material);
}

const after = (chunk: string, more: string): Edit => {
  const edit: Edit = (text) => text.replace(`#include <${chunk}>`, `#include <${chunk}>\n${more}`);
  edit.toString = () => `${chunk} ${more}`;
  return edit;
};

/** The text of a chunk, changed, in the place of its include. */
const changed = (chunk: keyof typeof THREE.ShaderChunk, from: string, to: string): Edit => {
  const edit: Edit = (text) => {
    if (!THREE.ShaderChunk[chunk].includes(from)) throw new Error(`no "${from}" in ${chunk}`);
    return text.replace(`#include <${chunk}>`, THREE.ShaderChunk[chunk].replaceAll(from, to));
  };
  edit.toString = () => `${chunk} ${from} ${to}`;
  return edit;
};

/** Every include by its text, as troika-three-text has it. */
const expand: Edit = (text) =>
  text.replace(/^[ \t]*#include +<([\w./]+)>/gm, (_, name: keyof typeof THREE.ShaderChunk) =>
    expand(THREE.ShaderChunk[name]),
  );

const { MeshLambertMaterial: Lambert, MeshPhongMaterial: Phong, MeshToonMaterial: Toon } = THREE;

/** Edits of a lit material's shader in which there still is a place for Farol's loop over the lights. */
export const shaderCases: Cases = {
  'all includes expanded, standard': () => edited(expand),
  'all includes expanded, Phong': () => edited(expand, new Phong({ color: 0x88aaff })),
  'all includes expanded, toon': () => edited(expand, new Toon({ color: 0x88ffaa })),
  'all includes expanded, Lambert, map': () => edited(expand, new Lambert({ map: colourMap() })),
  'all includes expanded, half seen through': () =>
    edited(expand, new THREE.MeshStandardMaterial({ transparent: true, opacity: 0.5 })),
  'the lights chunk alone expanded': () => edited(changed('lights_fragment_begin', 'RE_Direct', 'RE_Direct')),
  'after lights_fragment_begin': () => edited(after('lights_fragment_begin', 'reflectedLight.directDiffuse *= 0.5;')),
  'after lights_fragment_maps': () => edited(after('lights_fragment_maps', 'irradiance *= vec3(2.0, 0.5, 1.0);')),
  'after lights_fragment_end': () => edited(after('lights_fragment_end', 'reflectedLight.directDiffuse *= 1.5;')),
  'after lights_fragment_end, Phong': () =>
    edited(after('lights_fragment_end', 'reflectedLight.directSpecular *= 3.0;'), new Phong()),
  'after common': () =>
    edited((text) =>
      after(
        'common',
        'vec3 tint() { return vec3(0.3, 0.9, 0.4); }',
      )(after('color_fragment', 'diffuseColor.rgb *= tint();')(text)),
    ),
  'after normal_fragment_begin': () =>
    edited(after('normal_fragment_begin', 'normal = normalize(normal + 0.4 * sin(20.0 * vViewPosition.yzx));')),
  'light bent in lights_physical_pars_fragment': () =>
    edited(changed('lights_physical_pars_fragment', 'float dotNL = saturate( dot( geometryNormal, directLight.direction ) );', 'float dotNL = 0.5 + 0.5 * dot( geometryNormal, directLight.direction );')), // prettier-ignore
  'opaque_fragment by hand': () =>
    edited((text) => text.replace('#include <opaque_fragment>', 'gl_FragColor = vec4(outgoingLight.bgr, 1.0);')),
  'fog_fragment, tonemapping_fragment, colorspace_fragment': () =>
    edited((text) =>
      after(
        'fog_fragment',
        'gl_FragColor.r += 0.1;',
      )(
        after(
          'tonemapping_fragment',
          'gl_FragColor.g *= 0.8;',
        )(after('colorspace_fragment', 'gl_FragColor.b *= 0.7;')(text)),
      ),
    ),
  'clipping_planes_fragment by hand': () =>
    edited((text) => text.replace('#include <clipping_planes_fragment>', 'if (vViewPosition.x > 0.0) discard;')),
  'shadowmap_pars_fragment expanded': () => edited(changed('shadowmap_pars_fragment', 'getShadow(', 'getShadow(')),
  'a define for a chunk': () => {
    const mesh = edited(after('lights_fragment_end', '#ifdef HALF\nreflectedLight.directDiffuse *= 0.3;\n#endif'));
    (mesh.material as THREE.Material).defines = { STANDARD: '', HALF: 1 };
    return mesh;
  },
};

/** A shader of the host's own that loops over three's lights. */
const ownLoop = () =>
  new THREE.Mesh(
    ball(),
    new THREE.ShaderMaterial({
      lights: true,
      uniforms: THREE.UniformsUtils.clone(THREE.UniformsLib.lights),
      vertexShader: `varying vec3 vNormal2; varying vec3 vPosition2;
        void main() { vec4 p = modelViewMatrix * vec4(position, 1.0); vPosition2 = p.xyz; vNormal2 = normalMatrix * normal;
        gl_Position = projectionMatrix * p; }`,
      fragmentShader: `#include <common>
        #include <lights_pars_begin>
        varying vec3 vNormal2; varying vec3 vPosition2;
        void main() { vec3 sum = ambientLightColor;
        #if NUM_POINT_LIGHTS > 0
        for (int i = 0; i < NUM_POINT_LIGHTS; i++) { vec3 l = pointLights[i].position - vPosition2;
          sum += pointLights[i].color * max(dot(normalize(l), normalize(vNormal2)), 0.0) / (1.0 + dot(l, l)); }
        #endif
        gl_FragColor = vec4(sum, 1.0); }`,
    }),
  );

/** Edits after which three's own lights alone light the material as stock three does. */
export const lightShaderCases: Cases = {
  'lights_fragment_begin changed': () =>
    edited(changed('lights_fragment_begin', 'RE_Direct( directLight, geometryPosition, geometryNormal', 'RE_Direct( directLight, geometryPosition, - geometryNormal')), // prettier-ignore
  'lights_pars_begin changed': () => edited(changed('lights_pars_begin', 'light.color = pointLight.color;', 'light.color = pointLight.color.gbr;')), // prettier-ignore
  'lights_fragment_begin by hand': () =>
    edited(
      (text) =>
        text.replace(
          '#include <lights_fragment_begin>',
          `vec3 geometryPosition = -vViewPosition; vec3 geometryNormal = normal;
          vec3 geometryViewDir = normalize(vViewPosition); vec3 geometryClearcoatNormal = vec3(0.0);
          IncidentLight directLight;
          #if NUM_DIR_LIGHTS > 0
          getDirectionalLightInfo(directionalLights[0], directLight);
          RE_Direct(directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight);
          #endif
          vec3 iblIrradiance = vec3(0.0); vec3 irradiance = ambientLightColor; vec3 radiance = vec3(0.0); vec3 clearcoatRadiance = vec3(0.0);`,
        ),
      new Phong({ color: 0xffaa88 }),
    ),
  'changed, half seen through, double-sided': () =>
    edited(
      changed('lights_fragment_begin', 'geometryNormal = normal', 'geometryNormal = - normal'),
      new THREE.MeshStandardMaterial({ transparent: true, opacity: 0.5, side: THREE.DoubleSide }),
    ),
  'a loop of its own in a ShaderMaterial': ownLoop,
  'nothing changed beside them': () => new THREE.Mesh(ball(), new THREE.MeshStandardMaterial({ color: 0x88aacc })),
  'unlit beside them': () => new THREE.Mesh(ball(), new THREE.MeshBasicMaterial({ color: 0x336699 })),
};
