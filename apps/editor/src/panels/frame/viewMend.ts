import { t } from '@farol/editing';
import type { FieldValue } from '@farol/engine/fields';
import type { View } from '@farol/renderer';
import type { EditorApi } from '../../api/EditorApi';
import { setValues } from '../../model/edits';

/** Button that makes the renderer create the buffer of a debug view: its label, and what it does. */
export interface ViewMend {
  readonly label: string;
  run(): void;
}

/** Button that creates a view's buffer; null when the user has to choose, such as which light casts shadows. */
export function viewMend(editor: EditorApi, view: View): ViewMend | null {
  const { commands, document, viewport } = editor;
  const { settings } = document.scene;
  const set = (label: string, values: Record<string, FieldValue>): ViewMend => ({
    label,
    run: () => editor.attempt(() => commands.run(setValues(label, [settings], values))),
  });
  const choose = (label: string, technique: typeof viewport.technique): ViewMend => ({
    label,
    run: () => editor.attempt(() => void (viewport.technique = technique)),
  });
  switch (view) {
    case 'ambient-occlusion':
      return settings.ambientOcclusion
        ? choose(t('Choose the technique by itself'), 'auto')
        : set(t('Switch ambient occlusion on'), { ambientOcclusion: true });
    case 'motion':
    case 'reactive-mask':
      return settings.antialiasing === 'taa' ? null : set(t('Switch TAA on'), { antialiasing: 'taa' });
    case 'light-buffer':
      return choose(t('Draw by Light pre-pass'), 'light-prepass');
    case 'fog-light':
    case 'fog-transmittance':
    case 'froxels':
      return settings.volumetricFog ? null : set(t('Switch volumetric fog on'), { volumetricFog: true });
    default:
      return null;
  }
}
