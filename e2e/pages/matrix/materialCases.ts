import * as THREE from 'three';
import type { Cases } from './Case';
import { colourMap, cubeMap, equirect, greyMap, normalMap } from './textures';

const sphere = new THREE.SphereGeometry(0.65, 24, 16);
const { MeshPhysicalMaterial: Physical, MeshStandardMaterial: Standard } = THREE;
const on = (material: THREE.Material) => new THREE.Mesh(sphere, material);
const plane = (material: THREE.Material) => new THREE.Mesh(new THREE.PlaneGeometry(1.3, 1.3), material);

const waves = 'transformed += normal * 0.08 * sin(position.y * 12.0);';

/** Every material type of three, and a user's own shaders. */
export const materialCases: Cases = {
  basic: () => on(new THREE.MeshBasicMaterial({ map: colourMap(), color: 0xffeecc })),
  'basic, cube map multiplied': () =>
    on(new THREE.MeshBasicMaterial({ envMap: cubeMap(), combine: THREE.MultiplyOperation, reflectivity: 0.7 })),
  lambert: () => on(new THREE.MeshLambertMaterial({ color: 0x66ff88, map: colourMap() })),
  'lambert, cube map mixed': () =>
    on(new THREE.MeshLambertMaterial({ envMap: cubeMap(), combine: THREE.MixOperation, reflectivity: 0.4 })),
  phong: () => on(new THREE.MeshPhongMaterial({ color: 0x6688ff, specular: 0x888888, shininess: 40 })),
  'phong, cube map added, refracted': () => {
    const envMap = cubeMap();
    envMap.mapping = THREE.CubeRefractionMapping;
    return on(new THREE.MeshPhongMaterial({ envMap, combine: THREE.AddOperation, reflectivity: 0.3 }));
  },
  'phong brighter than white': () => on(new THREE.MeshPhongMaterial({ color: new THREE.Color(2, 1.5, 1) })),
  toon: () => on(new THREE.MeshToonMaterial({ color: 0xff66aa })),
  'toon, gradient map': () => {
    const gradientMap = new THREE.DataTexture(new Uint8Array([60, 120, 180, 255]), 4, 1, THREE.RedFormat);
    gradientMap.needsUpdate = true;
    return on(new THREE.MeshToonMaterial({ color: 0x66aaff, gradientMap }));
  },
  standard: () => on(new Standard({ color: 0xccaa88, roughness: 0.5, metalness: 0.2 })),
  'standard, metal': () => on(new Standard({ color: 0xffcc66, roughness: 0.3, metalness: 1 })),
  'standard, smooth': () => on(new Standard({ color: 0x445566, roughness: 0.12 })),
  'standard, maps of roughness and metalness': () =>
    on(new Standard({ roughnessMap: greyMap(), metalnessMap: greyMap(), metalness: 0.8, map: colourMap() })),
  'standard, environment of its own, turned': () =>
    on(
      new Standard({
        envMap: equirect(),
        envMapIntensity: 1.5,
        envMapRotation: new THREE.Euler(0.3, 1, 0.2),
        roughness: 0.2,
        metalness: 0.7,
      }),
    ),
  'physical, plain': () => on(new Physical({ color: 0x99bbaa, roughness: 0.35, ior: 1.8, specularIntensity: 0.6 })),
  'physical, specular colour': () =>
    on(new Physical({ color: 0x334455, roughness: 0.3, specularColor: new THREE.Color(1, 0.3, 0.1) })),
  'physical, clearcoat': () =>
    on(
      new Physical({
        color: 0x884422,
        roughness: 0.6,
        clearcoat: 1,
        clearcoatRoughness: 0.15,
        clearcoatNormalMap: normalMap(),
      }),
    ),
  'physical, sheen': () =>
    on(
      new Physical({
        color: 0x442266,
        roughness: 0.7,
        sheen: 1,
        sheenRoughness: 0.4,
        sheenColor: new THREE.Color(0.6, 0.5, 0.9),
      }),
    ),
  'physical, iridescence': () =>
    on(new Physical({ color: 0xaaaaaa, metalness: 0.6, roughness: 0.3, iridescence: 1, iridescenceIOR: 1.6 })),
  'physical, anisotropy': () =>
    on(new Physical({ color: 0xaaaaaa, metalness: 0.9, roughness: 0.35, anisotropy: 0.8, anisotropyRotation: 0.6 })),
  'physical, transmission': () =>
    on(
      new Physical({
        roughness: 0.1,
        transmission: 1,
        thickness: 0.6,
        attenuationColor: new THREE.Color(0.8, 0.9, 0.5),
        attenuationDistance: 1,
      }),
    ),
  'physical, dispersion': () =>
    on(new Physical({ roughness: 0, transmission: 0.9, thickness: 0.8, dispersion: 4, ior: 1.6 })),
  matcap: () => on(new THREE.MeshMatcapMaterial({ matcap: colourMap() })),
  normal: () => on(new THREE.MeshNormalMaterial()),
  depth: () => on(new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking })),
  points: () => new THREE.Points(sphere, new THREE.PointsMaterial({ color: 0xffaa44, size: 0.12 })),
  'points, transparent with a map, by pixels': () =>
    new THREE.Points(
      sphere,
      new THREE.PointsMaterial({ map: colourMap(), size: 4, sizeAttenuation: false, transparent: true, opacity: 0.6 }),
    ),
  line: () => new THREE.Line(sphere, new THREE.LineBasicMaterial({ color: 0x44ffaa })),
  'line segments, dashed': () => {
    const lines = new THREE.LineSegments(
      new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1)),
      new THREE.LineDashedMaterial({ dashSize: 0.1, gapSize: 0.06 }),
    );
    lines.rotation.set(0.5, 0.6, 0);
    return lines.computeLineDistances();
  },
  'line loop': () =>
    new THREE.LineLoop(new THREE.CircleGeometry(0.6, 12), new THREE.LineBasicMaterial({ vertexColors: false })),
  sprite: () => new THREE.Sprite(new THREE.SpriteMaterial({ map: colourMap(), rotation: 0.4, opacity: 0.8 })),
  'sprite of one size': () => {
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ color: 0xff8800, sizeAttenuation: false }));
    sprite.center.set(0.2, 0.3);
    sprite.scale.setScalar(0.06);
    return sprite;
  },
  shadow: () => plane(new THREE.ShadowMaterial({ opacity: 0.5 })),
  'shader, unlit': () =>
    on(
      new THREE.ShaderMaterial({
        uniforms: { tint: { value: new THREE.Color(0.2, 0.7, 0.9) } },
        vertexShader:
          'varying vec3 n; void main() { n = normalMatrix * normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
        fragmentShader:
          'varying vec3 n; uniform vec3 tint; void main() { gl_FragColor = vec4(tint * (0.5 + 0.5 * n.z), 1.0); }',
      }),
    ),
  'shader, lit by the chunks of three': () =>
    on(
      new THREE.ShaderMaterial({
        lights: true,
        uniforms: THREE.UniformsUtils.clone(THREE.ShaderLib.phong.uniforms) as Record<string, THREE.IUniform>,
        vertexShader: THREE.ShaderLib.phong.vertexShader,
        fragmentShader: THREE.ShaderLib.phong.fragmentShader.replace(
          '#include <opaque_fragment>',
          'outgoingLight = sqrt(outgoingLight);\n#include <opaque_fragment>',
        ),
      }),
    ),
  'shader, raw, GLSL 3': () =>
    on(
      new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3,
        vertexShader:
          'in vec3 position; uniform mat4 projectionMatrix, modelViewMatrix; out vec3 p; void main() { p = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
        fragmentShader:
          'precision highp float; in vec3 p; out vec4 colour; void main() { colour = vec4(abs(p), 1.0); }',
      }),
    ),
  'onBeforeCompile of vertices': () => {
    const material = new Standard({ color: 0x88aacc, roughness: 0.5 });
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace('#include <begin_vertex>', `#include <begin_vertex>\n${waves}`);
    };
    return on(material);
  },
  'onBeforeCompile of the lit colour': () => {
    const material = new Standard({ color: 0x88aacc, roughness: 0.5 });
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <dithering_fragment>',
        '#include <dithering_fragment>\ngl_FragColor.rgb = mix(sqrt(gl_FragColor.rgb), vec3(0.9, 0.2, 0.1), 0.3);',
      );
    };
    return on(material);
  },
  'onBeforeCompile that discards': () => {
    const material = new THREE.MeshLambertMaterial({ color: 0xccaa44 });
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <dithering_fragment>',
        '#include <dithering_fragment>\nif (fract(gl_FragCoord.x / 6.0) < 0.4) discard;',
      );
    };
    return on(material);
  },
  // black, so that no light is added to it
  'glow beyond half floats': () =>
    on(new THREE.MeshLambertMaterial({ color: 0, emissive: 0xff8800, emissiveIntensity: 1e5 })),
};
