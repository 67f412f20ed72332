import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import type { BuiltinSurface, BuiltinSurfaceName } from '../model/surfaces/builtinSurfaces';

/** An action that adds a surface to the library; the selected objects get it by a new material. */
const newSurface = (id: BuiltinSurfaceName, label: string, nameOf: () => string): Action => ({
  id: `surface.${id}`,
  label,
  icon: 'code',
  menu: { menu: 'object', group: 'material', submenu: 'New surface' },
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
  newSurface('directional', 'Thesis: directional light', () => t('Directional light')),
  newSurface('point', 'Thesis: point light', () => t('Point light')),
  newSurface('spot', 'Thesis: spot light', () => t('Spot light')),
  newSurface('plain', 'Tint', () => t('Tint')),
];
