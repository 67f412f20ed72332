/** Examples of the API's pages: each runs here, and is shown with its result as a comment. */
import { GameObject, Scene } from '@farol/engine';
import { number } from '@farol/editing/fields';
import {
  type BuiltinMicroShader,
  builtinMicroShaders,
  DepthPrepass,
  explainCompileError,
  ForwardPass,
  formatMicroShaderXML,
  forwardTail,
  forwardTwins,
  GBufferPass,
  gbufferLayout,
  gbufferUniforms,
  LightGridPass,
  LightTilesPass,
  litTwin,
  parseMicroShader,
  parseMicroShaderXML,
  targetBytes,
  type Technique,
  TiledOutputPass,
} from '@farol/renderer/authoring';
import { storeLightOptions } from '@farol/renderer/light-options';
import { IESError, IESLoader, parseIES, writeIES } from '@farol/renderer/light-profiles';
import {
  addSurface,
  canWearSurface,
  getSurfaces,
  layerSurface,
  Surface,
  surfaceReach,
  textOfMicroShaders,
} from '@farol/renderer/surfaces';
import { isOnGPU } from '@farol/renderer/vertex-data';
import { benchmarkLights, benchmarkLightsObjects, defineScene, dragons, preloadSceneCode, scenes } from '@farol/scenes';
import { BufferAttribute, MeshStandardMaterial, PointLight, ShaderMaterial, WebGLRenderTarget } from 'three';
import { expect, test } from 'vitest';

test('techniques are lists of passes', () => {
  const overTiles: Technique = {
    label: 'Depth, then lists of tiles',
    help: 'Lists of lights for tiles within their depths, walked by the materials.',
    lightOrder: 'by-depth',
    needsFloatTargets: false,
    passes: () => [new DepthPrepass(), new LightTilesPass('slices'), ...forwardTail('lightLoopTiled', ['light-lists'])],
  };
  expect(overTiles.passes()[0].writes).toContain('scene-depth');

  const overGBuffer: Technique = {
    label: 'Clusters over a G-buffer',
    help: 'Lists of lights by tile and depth, over a G-buffer.',
    lightOrder: 'by-grid',
    needsFloatTargets: true,
    fills: 'every-pixel',
    passes: () => [new GBufferPass(), new LightGridPass('gbuffer'), new TiledOutputPass()],
  };
  expect(overGBuffer.passes().length).toBe(3);

  const opaque = new ForwardPass({ name: 'opaque', list: 'opaque', loop: 'lightLoopAll' });
  expect(opaque.name).toBe('opaque');
});

test('twins and buffers', () => {
  expect(gbufferLayout.length).toBe(4);
  expect(Object.keys(gbufferUniforms()).length).toBe(12);
  expect(targetBytes(new WebGLRenderTarget(10, 10))).toBe(800);

  const lit = litTwin({ key: 'mine', loop: 'lightLoopAll' });
  expect(lit.key).toBe('mine');
  const { whole } = forwardTwins('lightLoopAll')('final'); // of three's materials, in one draw
  expect(whole.key).toBe('forward-lightLoopAll-final');
});

test('microshaders', () => {
  const chunks = [parseMicroShader('half', 'float half(const in float a) { return 0.5 * a; }')];
  const xml = formatMicroShaderXML(chunks);
  expect(parseMicroShaderXML(xml, 'mine.xml')[0].name).toBe('half');

  const name: BuiltinMicroShader = 'viewport';
  expect(builtinMicroShaders.some((each) => each.name === name)).toBe(true);

  const log = 'ERROR: 0:7: undeclared identifier';
  expect(explainCompileError(log, 'void main() {}')[0].message).toBe('undeclared identifier');
});

test('lights', () => {
  const lamp = new PointLight();
  storeLightOptions(lamp, { range: 12 }); // values that were checked before
  expect(lamp.userData.farol.range).toBe(12);
});

test('photometric files', () => {
  const text = 'IESNA:LM-63-2002\nTILT=NONE\n1 900 1 2 1 1 2 0 0 0\n1 1 20\n0 90\n0\n8 2\n';
  const profile = new IESLoader().parse(text);
  expect(profile.maximumIntensity).toBe(8);
  expect(writeIES(profile)).toContain('IESNA:LM-63-2002');
  expect(() => parseIES('no such file')).toThrow(IESError);
});

test('surfaces', () => {
  const glow = new Surface('glow', 'void surface(inout SurfaceData s) { s.emissive += 0.1; }');
  const wall = new MeshStandardMaterial();
  addSurface(wall, glow);
  expect(getSurfaces(wall).length).toBe(1);
  expect(canWearSurface(new ShaderMaterial())).toBe(false);

  const wet = new MeshStandardMaterial();
  const rain = new Surface('rain', 'void surface(inout SurfaceData s) { s.roughness *= 0.3; }');
  layerSurface(wet, wall, rain); // what the wall wears, and rain
  expect(surfaceReach(wet)).toBe(0);

  const chunks = [parseMicroShader('red', '//# main\ngl_FragColor = vec4(1.0, 0.0, 0.0, 1.0);')];
  const red = new Surface('red', textOfMicroShaders(chunks, ['red'])); // for a MeshBasicMaterial
  expect(red.name).toBe('red');
});

test('vertices', () => {
  expect(isOnGPU(new BufferAttribute(new Float32Array(3), 3))).toBe(false);
});

test('demo scenes', async () => {
  await preloadSceneCode(); // the builders then fetch nothing
  const field = await benchmarkLights(4, 2);
  expect(field.componentsOf('Light').length).toBe(5);
  const spheres = await benchmarkLightsObjects(4, 2, 'sphere');
  expect(spheres.componentsOf('Light').length).toBe(5);
  const four = await dragons({ lights: 5 });
  expect(four.componentsOf('Light').length).toBe(6);
  expect(Object.keys(scenes)).toContain('temple');

  const street = defineScene({
    name: 'street',
    label: 'Street',
    help: 'Lamps in a row.',
    parameters: { lamps: number(3, { min: 0, integer: true }) },
    sample: { lamps: 5 },
    make: async (get) => {
      const scene = new Scene();
      for (let i = 0; i < Number(get('lamps')); i++) scene.add(new GameObject(`Lamp ${i}`));
      return scene;
    },
  });
  const scene = await street.build({ lamps: 2 });
  expect(scene.find('Lamp 1')?.name).toBe('Lamp 1');
});
