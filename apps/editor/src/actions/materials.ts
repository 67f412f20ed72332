import { t } from '@farol/editing';
import { ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { BuiltinSurfaceName } from '../model/surfaces/builtinSurfaces';

/** Code of the actions, fetched when the first of them runs. */
const runs = async (): Promise<typeof import('./materialRuns')> => import('./materialRuns');

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
  run: async (editor) => (await runs()).newMaterial(editor, renderersOf(editor)),
};

/** Makes a library material from the first selected object with a material of its own; all selected objects get it. */
export const makeMaterial: Action = {
  id: 'material.make',
  label: 'Make material asset',
  icon: 'contrast',
  enabled: (editor) => renderersOf(editor).some(({ material, shader }) => material === null && shader === null),
  run: async (editor) => (await runs()).makeMaterial(editor, renderersOf(editor)),
};

/** Unpacks the selected models into trees of objects. */
export const unpackModel: Action = {
  id: 'model.unpack',
  label: 'Unpack model',
  icon: 'tree',
  enabled: (editor) => modelsOf(editor).length > 0,
  run: async (editor) => (await runs()).unpackModel(editor, modelsOf(editor)),
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
  run: async (editor) => (await runs()).newSurface(editor, id, nameOf()),
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
