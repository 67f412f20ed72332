import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { ActionButton } from '../../ui/ActionButton';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Flicker } from './Flicker';
import { flickerAll } from './flickerAll';

/** Lists the lights that flicker. */
export function LanternPanel(): ReactNode {
  const { document } = useEditor();
  useSignal(document.structure);
  const names: string[] = [];
  document.scene.traverse((object) => object.getComponent(Flicker) && names.push(object.name));
  return (
    <section className="panel" aria-label={t('Lantern')}>
      <div className="panel-bar">
        <ActionButton action={flickerAll} withLabel />
      </div>
      <p className="panel-empty">
        {names.length === 0 ? t('No lamp flickers.') : t('Flickering: {names}', { names: names.join(', ') })}
      </p>
    </section>
  );
}
