import { t } from '@farol/editing';
import type { ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { addMaterial, valuesOfOwnMaterial } from '../model/assetEdits';
import type { BuiltinSurface, BuiltinSurfaceName } from '../model/surfaces/builtinSurfaces';

/** Adds a material to the library, gives it to objects, and selects it. */
export function newMaterial(editor: EditorApi, renderers: readonly ObjectRenderer[]): void {
  const { document, commands } = editor;
  const { command, name } = addMaterial(document.scene, t('Material'), { kind: 'physical' }, renderers);
  commands.run(command);
  document.assetSelection.set([name]);
  editor.layout.open('inspector');
}

/** Makes a library material from the first object that has a material of its own, and assigns it to all objects. */
export function makeMaterial(editor: EditorApi, renderers: readonly ObjectRenderer[]): void {
  const { document, commands } = editor;
  const first = renderers.find(({ material, shader }) => material === null && shader === null)!;
  const materialName = t('{name} material', { name: first.gameObject.name });
  const made = addMaterial(document.scene, materialName, valuesOfOwnMaterial(first), renderers);
  commands.run(made.command);
  document.assetSelection.set([made.name]);
  editor.layout.open('inspector');
}

/** Unpacks models into trees of objects. */
export async function unpackModel(editor: EditorApi, models: readonly ModelRenderer[]): Promise<void> {
  const { unpackModels, whatStaysLinked } = await import('../model/unpackModels');
  const { document, commands } = editor;
  const { scene } = document;
  await Promise.all(models.map(({ model }) => document.assets.load(model!)));
  if (document.scene !== scene) return;
  const names = models.map(({ model }) => model!);
  commands.run(unpackModels(scene, models));
  const linked = whatStaysLinked(document.assets, names);
  if (linked !== null) editor.notices.show('info', linked);
}

/** Adds a surface to the library; the selected objects get it by a new material. */
export async function newSurface(editor: EditorApi, id: BuiltinSurfaceName, name: string): Promise<void> {
  const [{ builtinSurfaces }, { addSurface, surfaceWearers }] = await Promise.all([
    import('../model/surfaces/builtinSurfaces'),
    import('../model/surfaceEdits'),
  ]);
  const { document, commands } = editor;
  const users = surfaceWearers(document.selectedObjects);
  const { material, needsGrid }: BuiltinSurface = builtinSurfaces[id];
  let { source }: BuiltinSurface = builtinSurfaces[id];
  if (source === '') {
    const { thesisSurface } = await import('../model/surfaces/thesisSurface');
    source = await thesisSurface(id as 'directional' | 'point' | 'spot');
  }
  const made = addSurface(document.scene, name, source, material, users, needsGrid);
  commands.run(made.command);
  document.assetSelection.set([made.material ?? made.surface]);
  editor.layout.open('inspector');
}
