import { t } from '@farol/editing';
import { ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { BuiltinSurface, BuiltinSurfaceName } from '../model/surfaces/builtinSurfaces';

/** Renderers of the selected objects. */
export const renderersOf = ({ document }: EditorApi): ObjectRenderer[] =>
  document.selectedObjects.flatMap((object) => object.getComponent(ObjectRenderer) ?? []);

const modelsOf = ({ document }: EditorApi): ModelRenderer[] =>
  document.selectedObjects
    .flatMap((object) => object.getComponent(ModelRenderer) ?? [])
    .filter(({ model }) => model !== null);

/** Adds a material to the library, gives it to the selected objects, and selects it. */
export const newMaterial: Action = {
  id: 'material.new',
  label: 'New material',
  icon: 'contrast',
  async run(editor) {
    const { addMaterial } = await import('../model/assetEdits');
    const { document, commands } = editor;
    const { command, name } = addMaterial(document.scene, t('Material'), { kind: 'physical' }, renderersOf(editor));
    commands.run(command);
    document.assetSelection.set([name]);
    editor.layout.open('inspector');
  },
};

/** Makes a library material of the first selected object's own, and assigns it to all selected objects. */
export const makeMaterial: Action = {
  id: 'material.make',
  label: 'Make material asset',
  icon: 'contrast',
  enabled: (editor) => renderersOf(editor).some(({ material, shader }) => material === null && shader === null),
  async run(editor) {
    const { addMaterial, valuesOfOwnMaterial } = await import('../model/assetEdits');
    const { document, commands } = editor;
    const renderers = renderersOf(editor);
    const first = renderers.find(({ material, shader }) => material === null && shader === null)!;
    const materialName = t('{name} material', { name: first.gameObject.name });
    const made = addMaterial(document.scene, materialName, valuesOfOwnMaterial(first), renderers);
    commands.run(made.command);
    document.assetSelection.set([made.name]);
    editor.layout.open('inspector');
  },
};

/** Unpacks the selected models into trees of objects. */
export const unpackModel: Action = {
  id: 'model.unpack',
  label: 'Unpack model',
  icon: 'tree',
  enabled: (editor) => modelsOf(editor).length > 0,
  async run(editor) {
    const { unpackModels, whatStaysLinked } = await import('../model/unpackModels');
    const { document, commands } = editor;
    const { scene } = document;
    const models = modelsOf(editor);
    await Promise.all(models.map(({ model }) => document.assets.load(model!)));
    if (document.scene !== scene) return;
    const names = models.map(({ model }) => model!);
    commands.run(unpackModels(scene, models));
    const linked = whatStaysLinked(document.assets, names);
    if (linked !== null) editor.notices.show('info', linked);
  },
};

/** Adds a script to the library and its component to the selected objects, and opens the script. */
export const newScript: Action = {
  id: 'script.new',
  label: 'New script',
  icon: 'code',
  async run(editor) {
    const { newScript: make } = await import('../files/newScript');
    make(editor, t('Script'), editor.document.selectedObjects);
  },
};

/** An action that adds a surface to the library; the selected objects get it by a new material. */
const newSurface = (id: BuiltinSurfaceName, label: string, nameOf: () => string): Action => ({
  id: `surface.${id}`,
  label,
  icon: 'code',
  async run(editor) {
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
    const made = addSurface(document.scene, nameOf(), source, material, users, needsGrid);
    commands.run(made.command);
    document.assetSelection.set([made.material ?? made.surface]);
    editor.layout.open('inspector');
  },
});

export const newSurfaces: readonly Action[] = [
  newSurface('waves', 'Waves', () => t('Waves')),
  newSurface('water', 'Water', () => t('Water')),
  newSurface('snow', 'Snow', () => t('Snow')),
  newSurface('moss', 'Moss', () => t('Moss')),
  newSurface('dissolve', 'Dissolve', () => t('Dissolve')),
  newSurface('rust', 'Rust', () => t('Rust')),
  newSurface('hologram', 'Hologram', () => t('Hologram')),
  newSurface('directional', 'Phong, directional light', () => t('Directional light')),
  newSurface('point', 'Phong, point light', () => t('Point light')),
  newSurface('spot', 'Phong, spot light', () => t('Spot light')),
  newSurface('plain', 'Tint', () => t('Tint')),
];
