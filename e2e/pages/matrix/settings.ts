import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import type { Setting } from './Stage';
import { colourMap, cubeMap, equirect } from './textures';

const ortho = () => {
  const camera = new THREE.OrthographicCamera(-3, 3.4, 2.2, -2, 0.5, 30);
  camera.position.set(0.5, 0.2, 7);
  camera.zoom = 1.1;
  camera.lookAt(0, 0, 0);
  camera.updateProjectionMatrix();
  return camera;
};

/** Draws with the tone mapping, fog and colour space of the canvas. */
const mapped = (
  stage: { webgl: THREE.WebGLRenderer },
  draw: () => void,
  space: THREE.ColorSpace = THREE.SRGBColorSpace,
) => {
  const { webgl } = stage;
  webgl.toneMapping = THREE.ACESFilmicToneMapping;
  webgl.toneMappingExposure = 1.3;
  webgl.outputColorSpace = space;
  draw();
  webgl.toneMapping = THREE.NoToneMapping;
  webgl.toneMappingExposure = 1;
  webgl.outputColorSpace = THREE.SRGBColorSpace;
};

/** Settings by name. A new one is an entry. */
export const settings: Record<string, Setting> = {
  'camera off centre': {
    prepare: ({ camera, width, height }) => camera.setViewOffset(width * 1.5, height * 1.5, 30, 10, width, height),
  },
  'orthographic camera off centre': { draw: ({ scene }, render) => render(scene, ortho()) },
  'several cameras, with viewport and scissor': {
    draw({ webgl, scene, camera, width, height }, render) {
      const target = webgl.getRenderTarget()!;
      for (let i = 0; i < 2; i++) {
        target.viewport.set((i * width) / 2, 4, width / 2, height - 4);
        target.scissor.copy(target.viewport);
        target.scissorTest = true;
        webgl.setRenderTarget(target);
        render(scene, i === 0 ? camera : ortho());
      }
      target.viewport.set(0, 0, width, height);
      target.scissorTest = false;
      webgl.setRenderTarget(target);
    },
  },
  'array of cameras': {
    draw({ scene, camera, width, height }, render) {
      const cameras = [0, 1, 2].map((i) => {
        const one = camera.clone() as THREE.PerspectiveCamera & { viewport: THREE.Vector4 };
        one.position.x += i - 1;
        one.viewport = new THREE.Vector4((i * width) / 3, i * 4, width / 3, height - 8);
        one.updateMatrixWorld();
        return one;
      });
      const array = new THREE.ArrayCamera(cameras);
      array.copy(camera, false);
      array.cameras = cameras;
      render(scene, array);
    },
  },
  'layers of the camera': {
    prepare({ camera, things, scene }) {
      things[1].layers.set(2);
      things[2].layers.set(3);
      scene.children.find((child) => child instanceof THREE.PointLight)!.layers.set(3);
      camera.layers.enable(2);
    },
  },
  'autoClear off, two scenes, stock three between': {
    draw({ webgl, scene, camera, things }, render) {
      const second = new THREE.Scene();
      const ball = things[2].clone();
      ball.position.set(0, 0, 1.2);
      second.add(ball, new THREE.DirectionalLight(0xffffff, 1));
      const third = new THREE.Scene();
      third.add(new THREE.Mesh(new THREE.BoxGeometry(0.5, 0.5, 5), new THREE.MeshNormalMaterial()));
      render(scene, camera);
      webgl.autoClear = false;
      webgl.render(third, camera);
      render(second, camera);
      webgl.autoClear = true;
    },
  },
  'a group in place of a scene': {
    draw: ({ scene, camera }, render) =>
      render(new THREE.Group().add(...scene.children.map((child) => child.clone())), camera),
  },
  'not sorted': {
    draw({ webgl, scene, camera }, render) {
      webgl.sortObjects = false;
      render(scene, camera);
      webgl.sortObjects = true;
    },
  },
  'clipping planes of the renderer': {
    draw({ webgl, scene, camera }, render) {
      webgl.clippingPlanes = [new THREE.Plane(new THREE.Vector3(1, 0.5, 0).normalize(), 0.8)];
      render(scene, camera);
      webgl.clippingPlanes = [];
    },
  },
  'override material, lit': {
    prepare: ({ scene }) => (scene.overrideMaterial = new THREE.MeshPhongMaterial({ color: 0x99cc66 })),
  },
  'override material, not allowed by one': {
    prepare({ scene, things }) {
      scene.overrideMaterial = new THREE.MeshNormalMaterial();
      (things[1].material as THREE.Material).allowOverride = false;
    },
  },
  'fog, linear': { prepare: ({ scene }) => (scene.fog = new THREE.Fog(0x668899, 5, 9)) },
  'fog, exponential': { inVerify: true, prepare: ({ scene }) => (scene.fog = new THREE.FogExp2(0x668899, 0.12)) },
  'background of a texture': { inVerify: true, prepare: ({ scene }) => (scene.background = colourMap()) },
  'background of a cube, fainter and turned': {
    prepare({ scene, things }) {
      things[0].visible = false;
      scene.background = cubeMap();
      scene.backgroundIntensity = 0.7;
      scene.backgroundRotation.set(0.3, 0.8, 0);
    },
  },
  'background of an equirectangular map, blurred': {
    prepare({ scene, things }) {
      things[0].visible = false;
      scene.background = equirect();
      scene.backgroundBlurriness = 0.4;
    },
  },
  'no background, a clear colour that is half transparent': {
    prepare: ({ scene, things }) => {
      scene.background = null;
      things[0].visible = false;
    },
    draw({ webgl, scene, camera }, render) {
      webgl.setClearColor(0x446622, 0.5);
      render(scene, camera);
      webgl.setClearColor(0x000000, 0);
    },
  },
  'environment, turned and strong': {
    prepare({ scene, environment }) {
      scene.environment = environment;
      scene.environmentIntensity = 1.4;
      scene.environmentRotation.set(0.4, 1, 0);
    },
  },
  'environment without a mapping': {
    inVerify: true,
    prepare: ({ scene }) => (scene.environment = new THREE.Texture()),
  },
  'rectangle light and probe': {
    prepare({ scene }) {
      RectAreaLightUniformsLib.init();
      const light = new THREE.RectAreaLight(0xffaa66, 6, 2, 1);
      light.position.set(1, 1, 2);
      light.lookAt(0, 0, 0);
      const probe = new THREE.LightProbe(undefined, 0.6);
      probe.sh.coefficients.forEach((value, i) => value.set(0.5 / (i + 1), 0.3, 0.2 + 0.05 * i));
      scene.add(light, probe);
    },
  },
  transmission: {
    inVerify: true,
    prepare: ({ things }) =>
      (things[2].material = new THREE.MeshPhysicalMaterial({ transmission: 1, thickness: 0.5, roughness: 0.2 })),
  },
  'target of 8 bits in sRGB': { target: { type: THREE.UnsignedByteType, colorSpace: THREE.SRGBColorSpace } },
  'camera in a group that is moved': {
    prepare({ camera, scene }) {
      const group = new THREE.Group();
      group.position.set(0.4, 0.3, 0.2);
      group.rotation.z = 0.2;
      group.add(camera);
      scene.add(group);
    },
  },
  'a scene that updates no matrices': {
    prepare({ scene, things }) {
      scene.updateMatrixWorld();
      scene.matrixWorldAutoUpdate = false;
      things[1].position.x += 5;
    },
  },
  'two FarolRenderers on one WebGLRenderer, one made anew': {
    draw({ webgl, scene, camera }, render, farol) {
      render(scene, camera);
      if (farol === null) return;
      const other = new FarolRenderer(webgl, { technique: farol.technique });
      other.render(scene, ortho());
      other.dispose();
      render(scene, camera);
    },
  },
  canvas: { canvas: true },
  'canvas, tone mapping and fog, but not for all': {
    canvas: true,
    prepare({ scene, things }) {
      scene.fog = new THREE.Fog(0x668899, 5, 9);
      things[1].material = (things[1].material as THREE.Material).clone();
      (things[1].material as THREE.Material).toneMapped = false;
      things[2].material = (things[2].material as THREE.Material).clone();
      (things[2].material as THREE.MeshPhongMaterial).fog = false;
    },
    draw: (stage, render) => mapped(stage, () => render(stage.scene, stage.camera)),
  },
  'canvas of linear colours': {
    inVerify: true,
    canvas: true,
    draw: (stage, render) => mapped(stage, () => render(stage.scene, stage.camera), THREE.LinearSRGBColorSpace),
  },
  'canvas with a pixel ratio, after a change of size': {
    canvas: true,
    draw({ webgl, scene, camera, width, height }, render) {
      webgl.setPixelRatio(1.5);
      webgl.setSize(width / 2, height / 2, false);
      render(scene, camera);
      webgl.setPixelRatio(1);
      webgl.setSize(width, height, false);
      render(scene, camera);
    },
  },
  'logarithmic depth': {
    inVerify: true,
    renderer: { logarithmicDepthBuffer: true },
    prepare: ({ camera }) => ((camera.far = 1e6), camera.updateProjectionMatrix()),
  },
  'logarithmic depth, orthographic': {
    inVerify: true,
    renderer: { logarithmicDepthBuffer: true },
    draw: ({ scene }, render) => render(scene, ortho()),
  },
  'reversed depth': { inVerify: true, renderer: { reversedDepthBuffer: true } },
  'reversed depth, orthographic': {
    inVerify: true,
    renderer: { reversedDepthBuffer: true },
    draw: ({ scene }, render) => render(scene, ortho()),
  },
  'canvas through a buffer of half floats': {
    // a context of its own; antialiasOption.spec.ts has such a buffer too
    inVerify: true,
    renderer: { outputBufferType: THREE.HalfFloatType },
    canvas: true,
    draw: (stage, render) => mapped(stage, () => render(stage.scene, stage.camera)),
  },
};
