import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readFileSync } from 'node:fs';
import { parseSync } from 'vite';
import { describe, expect, test } from 'vitest';
import * as main from './index';

const source = fileURLToPath(new URL('.', import.meta.url));

/** Exports of the main entry besides types: a new name must be one that every author needs. */
const names = {
  app: ['App', 'createWebGLRenderer', 'noWebGL2'],
  loopsOfOnesOwn: [
    'followEffects',
    'InputRouter',
    'MicroShaderOverrides',
    'PictureRenderer',
    'effectFields',
    'techniqueAbilities',
    'TouchControls',
    'watchPixelRatio',
  ],
  scene: [
    'Scene',
    'FieldAsset',
    'sourceOfMaterial',
    'GameObject',
    'ClipAsset',
    'Component',
    'createRandom',
    'gameObjectOf',
    'hitPoint',
    'rayHits',
    'shapeOf',
  ],
  components: [
    ...[
      'Animation',
      'Animator',
      'Camera',
      'Decal',
      'FogVolume',
      'KeyController',
      'Light',
      'LightGroup',
      'ModelRenderer',
      'MouseController',
      'ObjectRenderer',
      'ParticleEmitter',
      'particlePreset',
    ],
    ...['CharacterController', 'Collider', 'Joint', 'PhysicsSystem', 'RigidBody'],
    ...['lightShadows', 'meshShadows', 'soloLights', 'sunShadows'],
    ...[
      'RandomMovement',
      'Room',
      'ScriptAsset',
      'Sound',
      'SunAndMoon',
      'SurfaceAsset',
      'Transform',
      'Wall',
      'ComponentRegistry',
      'builtinComponents',
    ],
    ...['AudioListener', 'AudioSource', 'EventTrigger', 'audioOutput', 'Grabbable', 'XRRig'],
  ],
  animation: [
    'ClipError',
    'ClipPreview',
    'clipText',
    'cubicBezier',
    'modelBelow',
    'objectAtPath',
    'objectsByName',
    'parseClip',
    'pathBelow',
    'targetOfTrack',
    'trackTarget',
    'valueAt',
  ],
  assets: [
    'addMeshPack',
    'AssetLibrary',
    'AssetError',
    'MaterialAsset',
    'Model',
    'ModelClip',
    'importModel',
    'isOfSubtree',
    'isUnpackable',
    'keptTogether',
    'modelsBelow',
    'morphField',
    'objectOfPart',
    'objectsOfModel',
    'partsText',
    'subtreeOf',
    'whatKeepsTogether',
  ],
};

test('the main entry exports these names', () => {
  expect(Object.keys(main).toSorted()).toEqual(Object.values(names).flat().toSorted());
});

/** Modules that a module imports statically, without types. */
function importsOf(path: string): string[] {
  const { module } = parseSync(path, readFileSync(path, 'utf8'));
  const requests = [
    ...module.staticImports.filter(({ entries }) => entries.length === 0 || entries.some(({ isType }) => !isType)),
    ...module.staticExports.flatMap(({ entries }) => entries.filter(({ isType }) => !isType)),
  ];
  return requests.flatMap(({ moduleRequest }) =>
    moduleRequest?.value.startsWith('.') ? [join(dirname(path), `${moduleRequest.value}.ts`)] : [],
  );
}

/** All modules loaded with an entry, as paths relative to `src`. */
function loadedWith(entry: string): string[] {
  const loaded = new Set([join(source, entry)]);
  for (const path of loaded) for (const next of importsOf(path)) loaded.add(next);
  return [...loaded].map((path) => path.slice(source.length)).toSorted();
}

describe('what is loaded with the main entry', () => {
  const loaded = loadedWith('index.ts');

  test('is found by following imports', () => {
    expect(loaded).toEqual(expect.arrayContaining(['core/Scene.ts', 'components/Light.ts', 'assets/AssetLibrary.ts']));
    expect(loadedWith('files/index.ts')).toContain('guard/zip/readZip.ts');
  });

  test.each([
    ['prefabs', []],
    ['files', []],
  ])('of %s: %j', (folder, needed) => {
    expect(loaded.filter((path) => path.startsWith(`${folder}/`))).toEqual(needed);
  });

  test('holds nothing that reads the bytes of an asset; the text of a clip is read where it is played', () => {
    const readers = loaded.filter((path) => /(read|check|parse|pack)[A-Z]\w+\.ts$/.test(path));
    expect(readers).toEqual(['assets/clips/parseClip.ts']);
  });
});
