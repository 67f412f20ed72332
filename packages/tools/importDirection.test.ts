import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { importGraph } from './importCircles.mjs';
import { importViolations, isTestCode } from './importDirection.mjs';
import { root } from './root.mjs';
import { sourceFiles } from './sourceFiles.mjs';

const workspaces = [
  'packages/renderer',
  'packages/engine',
  'packages/scenes',
  'packages/editing',
  'packages/bake',
  'packages/attach',
  'packages/mcp',
  'packages/tools',
  'apps/viewer',
  'apps/editor',
  'apps/lab/rivals',
  'apps/lab',
];
const manifests = new Map(
  ['', ...workspaces].map((folder) => [
    folder,
    JSON.parse(readFileSync(join(root, folder, 'package.json'), 'utf8')) as { dependencies?: object },
  ]),
);

describe('the direction of imports', () => {
  it('holds in every source file', () => {
    const files = sourceFiles();
    expect(files.size).toBeGreaterThan(20);
    expect(importViolations(files, manifests)).toEqual([]);
  });

  it('leads down through nine floors of folders in the renderer', () => {
    const home = 'packages/renderer/src/';
    const files = new Map([...sourceFiles()].filter(([path]) => path.startsWith(home) && !isTestCode(path)));
    const folderOf = (path: string): string => path.slice(home.length).replace(/\/?[^/]*$|\/.*/, '');
    const below = new Map<string, Set<string>>();
    for (const [path, targets] of importGraph(files)) {
      const from = folderOf(path);
      if (!below.has(from)) below.set(from, new Set());
      for (const to of [...targets.static, ...targets.types].map(folderOf)) if (to !== from) below.get(from)!.add(to);
    }
    const floorOf = (folder: string): number => 1 + Math.max(0, ...[...(below.get(folder) ?? [])].map(floorOf));
    expect(Math.max(...[...below.keys()].map(floorOf))).toBeLessThanOrEqual(9);
  });

  it.each([
    ['packages/renderer/src/microshaders/X.ts', "import { P } from '../forward/P';", /may import/],
    ['packages/renderer/src/X.ts', "import type { Scene } from '@farol/engine';", /may import/],
    ['packages/engine/src/physics/X.ts', "import { box } from './testing/box';", /does not use what tests share/],
    ['packages/renderer/src/X.ts', "export * from '../../engine/src/Scene';", /may import/],
    ['packages/renderer/src/lights/X.ts', "import type { DataTable } from '../gpu/DataTable';", /may import/],
    [
      'packages/renderer/src/lights/X.ts',
      "import { type Light, type Texture } from 'three';",
      /imports Texture of three/,
    ],
    [
      'packages/renderer/src/lights/X.ts',
      "import type { WebGLRenderer } from 'three';",
      /imports WebGLRenderer of three/,
    ],
    ['packages/renderer/src/lights/X.ts', "import * as THREE from 'three';", /imports \* of three/],
    ['packages/engine/src/X.ts', "const lazy = () => import('react');", /may import/],
    ['packages/renderer/src/index.ts', "export * from './adapters/r3f/Farol';", /does not know what plugs it in/],
    ['packages/renderer/src/gbuffer/X.ts', "import { E } from '../effects/x/E';", /types only/],
    ['packages/renderer/src/gbuffer/X.ts', "import { type W, w } from '../effects/x/W';", /types only/],
    ['packages/renderer/src/gbuffer/X.ts', "export { w } from '../effects/x/W';", /types only/],
    ['packages/renderer/src/gbuffer/X.ts', "const w = () => import('../effects/x/W');", /types only/],
    ['packages/renderer/src/renderer/lazyCode.ts', "import { w } from '../effects/x/W';", /by import\(\) only/],
    ['packages/renderer/src/views/X.ts', "import { A } from '../authoring';", /does not know what plugs it in/],
    ['packages/renderer/src/frame/X.ts', "import type { F } from '../renderer/FarolRenderer';", /may import/],
    ['packages/renderer/src/gbuffer/X.ts', "import type { E } from '../effects/x/E';", /may import/],
    ['packages/renderer/src/index.ts', "import type { E } from './effects/x/E';", /does not know what plugs it in/],
    ['packages/renderer/src/index.ts', "import 'react';", /may import/],
    ['packages/engine/src/core/X.ts', "import { Light } from '../components/Light';", /does not know what plugs it in/],
    [
      'packages/engine/src/assets/X.ts',
      "import type { Scene } from '../core/Scene';",
      /does not know what plugs it in/,
    ],
    [
      'packages/engine/src/physics/X.ts',
      "import type { J } from '../components/Joint';",
      /does not know what plugs it/,
    ],
    ['packages/engine/src/physics/X.ts', "import { A } from '../animation/Channel';", /does not know what plugs it in/],
    ['packages/engine/src/components/X.ts', "import('../picture/PictureRenderer')", /does not know what plugs it in/],
    [
      'packages/engine/src/files/X.ts',
      "import { makePrefab } from '../prefabs/makePrefab';",
      /does not know what plugs/,
    ],
    ['packages/engine/src/base/X.ts', "import { number } from '../componentFields';", /does not know what plugs it in/],
    ['packages/engine/src/X.ts', "import { attachEditor } from '@farol/attach';", /may import/],
    ['packages/editing/src/X.ts', "import type { Field } from '@farol/engine';", /may import/],
    ['packages/editing/src/X.ts', "import { useEffect } from 'react';", /may import/],
    ['packages/attach/src/X.ts', "import { number } from '@farol/engine/fields';", /may import/],
    ['packages/renderer/src/adapters/three-pass/X.ts', "import 'postprocessing';", /may import/],
    ['packages/engine/src/X.ts', "import { readFileSync } from 'node:fs';", /no Node modules/],
    [
      'packages/engine/src/X.ts',
      "import { G } from '@farol/renderer/src/gbuffer/GBuffer';",
      /published entries of @farol\/renderer .*@farol\/renderer\/r3f/,
    ],
    ['packages/engine/src/X.ts', "import react from '@vitejs/plugin-react';", /may import/],
    ['packages/engine/src/X.test.ts', "import { h } from 'preact';", /may import/],
    ['apps/editor/src/X.tsx', "import { gui } from '@farol/viewer'; const a = <b>c</b>;", /nothing imports an app/],
    ['apps/editor/src/X.ts', "import '../../viewer/src/main';", /may import/],
    ['apps/editor/src/model/X.ts', "import type { Viewport } from '../viewport/Viewport';", /may import/],
    ['apps/editor/src/viewport/X.ts', "import type { EditorApi } from '../api/EditorApi';", /may import/],
    ['apps/editor/src/files/X.ts', "import { save } from '../actions/save';", /may import/],
    ['apps/editor/src/actions/X.ts', "import { panels } from '../panels';", /may import/],
    ['apps/editor/src/fields/X.tsx', "import('../panels/dialogs/TextDialog');", /may import/],
    ['apps/editor/src/panels/x/X.tsx', "import type { Editor } from '../../Editor';", /may import/],
    ['apps/viewer/src/X.ts', "import { create } from 'zustand';", /does not declare zustand/],
    ['e2e/render/x.spec.ts', "import { Scene } from '../../packages/engine/src/Scene';", /may import/],
    ['e2e/render/x.spec.ts', "import x from 'lil-gui';", /does not declare lil-gui/],
  ])('is broken by %s: %s', (path, source, why) => {
    const found = importViolations(new Map([[path, source]]), manifests);
    expect(found).toHaveLength(1);
    expect(found[0]).toMatch(why);
  });

  it.each([
    ['packages/renderer/src/passes/X.ts', "import text from './x.glsl?raw'; import 'three';"],
    ['packages/renderer/src/lights/X.ts', "import { type SpotLight, Vector3 } from 'three'; import './Y';"],
    ['packages/renderer/src/frame/X.test.ts', "import { F } from '../renderer/FarolRenderer';"],
    ['packages/renderer/src/lights/X.test.ts', "import { Texture } from 'three';"],
    ['packages/engine/src/core/X.test.ts', "import { Light } from '../components/Light';"],
    ['packages/engine/src/physics/testing/box.ts', "import { Collider } from '../../components/Collider';"],
    ['packages/engine/src/prefabs/X.ts', "import '../files/serialize'; import type { S } from '../core/Scene';"],
    ['packages/engine/src/X.test.ts', "import { it } from 'vitest'; import { Scene } from './Scene';"],
    [
      'packages/renderer/src/adapters/r3f/X.ts',
      "import { useRef } from 'react'; import { F } from '../../renderer/FarolRenderer';",
    ],
    ['apps/viewer/src/X.ts', "import { FarolPass } from '@farol/renderer/three-pass';"],
    [
      'apps/editor/src/panels/x/X.tsx',
      "import { a } from '../../fields'; import '../../api/EditorApi'; import 'react';",
    ],
    ['apps/editor/src/Editor.ts', "import { panels } from './panels'; import './plugins/startPlugins';"],
    ['apps/editor/vite.config.ts', "import react from '@vitejs/plugin-react';"],
    ['packages/engine/src/X.ts', "// import 'react'\nconst text = \"import 'react'\";"],
    ['apps/viewer/src/X.ts', "import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';"],
    ['e2e/pages/x.ts', "import { techniques } from '@farol/renderer';"],
    [
      'packages/renderer/src/renderer/X.ts',
      "import type { W } from '../effects/w'; export type { V } from '../effects/w';",
    ],
    ['packages/renderer/src/renderer/X.ts', "import type { W, V } from '../effects/w';"],
    [
      'packages/renderer/src/renderer/lazyCode.ts',
      "const w = () => import('../effects/w'); import type { W } from '../effects/w';",
    ],
  ])('allows %s: %s', (path, source) => {
    expect(importViolations(new Map([[path, source]]), manifests)).toEqual([]);
  });
});
