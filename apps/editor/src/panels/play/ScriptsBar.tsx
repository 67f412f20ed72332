import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { OffReason } from '../../model/DocumentScripts';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './scriptsBar.css';
import { Button } from '../../ui/Button';

const textOf = (reason: OffReason): string =>
  ({
    foreign: t('The scripts of this scene are off, since it comes from elsewhere. Run them only if you trust it.'),
    hung: t('Scripts are off: the page ended while they ran. Correct the one that does not end, then run them.'),
    address: t('Scripts are off, by ?scripts=off in the address.'),
    framed: t(
      'Scripts stay off while another page shows the editor inside of it. Open the editor by itself to run them.',
    ),
  })[reason];

/** Banner while the scene's scripts are off: the reason, and buttons to run them or not. */
export function ScriptsBar(): ReactNode {
  const editor = useEditor();
  const { scripts } = editor.document;
  useSignal(scripts.changed);
  const { question } = scripts;
  if (!question) return null;
  return (
    <section className="scripts-bar" role="alert" aria-label={t('Scripts are off')}>
      <p>{textOf(question)}</p>
      <div className="scripts-bar-buttons">
        <Button label={t('Look at them')} onClick={() => editor.layout.open('scripts')} />
        <Button label={t('Keep them off')} onClick={() => scripts.keepOff()} />
        {question !== 'framed' && <Button look="primary" label={t('Run them')} onClick={() => (scripts.isOn = true)} />}
      </div>
    </section>
  );
}
