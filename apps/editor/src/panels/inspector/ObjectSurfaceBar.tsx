import { t } from '@farol/editing';
import { type Component, ModelRenderer, ObjectRenderer } from '@farol/engine';
import { type ReactNode, useState } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { EditSurface } from '../material/EditSurface';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { Button } from '../../ui/Button';

/** Buttons for the surface of objects. @param props.components - memoised; nothing is shown when none has a surface */
export function ObjectSurfaceBar({ components }: { components: readonly Component[] }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  const [wearers] = useState(() =>
    components.filter((each) => each instanceof ObjectRenderer || each instanceof ModelRenderer),
  );
  useOwnersRevision(components);
  useSignal(document.assetsChanged);
  useSignal(document.materials);
  if (wearers.length === 0) return null;
  const [{ surface }] = wearers;
  if (surface !== null)
    return wearers.every((each) => each.surface === surface) ? (
      <div className="material-bar">
        <EditSurface name={surface} />
      </div>
    ) : null;
  const renderers = wearers.filter((each) => each instanceof ObjectRenderer);
  const name = renderers.length === wearers.length ? renderers[0].material : null;
  const material = name === null ? null : document.assets.materialAsset(name);
  const worn = material?.get('surface') as string | null | undefined;
  if (!material || !worn || !renderers.every((each) => each.material === name && each.shader === null)) return null;
  const makeOwnValues = async (): Promise<void> => {
    const { ownSurfaceValues } = await import('../../model/surfaceEdits');
    commands.run(ownSurfaceValues(renderers, material));
  };
  return (
    <div className="material-bar">
      <Button
        icon="sliders"
        label={t('Own values of {surface}', { surface: worn })}
        title={t('The values of the surface for this object alone; others of the material keep theirs')}
        onClick={() => editor.attempt(makeOwnValues)}
      />
    </div>
  );
}
