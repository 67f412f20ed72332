import { t } from '@farol/editing';
import { ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';

/** Buttons for a surface asset, its uniforms, and its errors. */
export function SurfaceAssetBar({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.selection.changed);
  const asset = document.assets.surface(name);
  const users = document.selectedObjects.filter(
    (object) => object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer),
  );
  const wear = async (): Promise<void> => {
    const { surfaceWearers, wearSurface } = await import('../../model/surfaceEdits');
    commands.run(wearSurface(name, surfaceWearers(users)));
  };
  return (
    <div className="script-asset">
      <button type="button" className="button framed" onClick={() => editor.openMicroShader(`surface:${name}`)}>
        <Icon name="code" />
        <span>{t('Edit ## the text of a script')}</span>
      </button>
      <button
        type="button"
        className="button framed"
        disabled={users.length === 0}
        onClick={() => editor.attempt(wear)}
      >
        <Icon name="check" />
        <span>{t('Give to the selected objects')}</span>
      </button>
      <ul className="model-inside">
        {asset?.surface?.uniforms.map((uniform) => (
          <li key={uniform.name}>
            <span>{uniform.label}</span>
            <span className="used-field">{`${uniform.name} · ${uniform.type}`}</span>
          </li>
        ))}
      </ul>
      {asset?.problem && (
        <p className="script-error">
          <Icon name="warning" size={12} />
          <span>{asset.problem.message}</span>
        </p>
      )}
    </div>
  );
}
