import type { ReactNode } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { surfaceEntries } from '../assets/assetMenu';
import { Icon } from '../../ui/Icon';
import { Button } from '../../ui/Button';

/** Buttons for a surface asset, its uniforms, and its errors. */
export function SurfaceAssetBar({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.selection.changed);
  const asset = document.assets.surface(name);
  return (
    <div className="script-asset">
      {surfaceEntries(editor, name).map(({ label, icon, disabled, run }) => (
        <Button key={label} {...{ label, icon, disabled }} onClick={run} />
      ))}
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
