import { t, toDegrees } from '@farol/editing';
import { type FieldValue, isTriple, sameValue } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { nameOf, type PlayChange } from '../../model/PlayEdits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { IconButton } from '../../ui/IconButton';
import { keysText } from '../../ui/keysText';
import './play.css';
import { Button } from '../../ui/Button';

/** Text of a value, formatted as in the inspector. */
function valueText(value: FieldValue, kind: string): string {
  if (value === null) return t('none');
  const isAngle = kind === 'angle' || kind === 'euler';
  const text = (each: number): string => String(Number((isAngle ? toDegrees(each) : each).toPrecision(4)));
  if (typeof value === 'number') return text(value) + (isAngle ? '°' : '');
  if (isTriple(value)) return value.map((each) => text(each)).join('  ');
  if (Array.isArray(value)) return keysText(value);
  return typeof value === 'boolean' ? (value ? t('on') : t('off')) : String(value);
}

/** Edits made while the scene played, shown after it stopped; each value can be kept. */
export function PlayChanges(): ReactNode {
  const editor = useEditor();
  const { playEdits, edited } = editor.document;
  useSignal(playEdits.changed);
  useSignal(edited);
  const { changes, others } = playEdits;
  if (changes.length === 0 && others.length === 0) return null;
  return (
    <section className="play-changes" aria-label={t('Edited while playing')}>
      <header>
        <h2>{t('Edited while playing')}</h2>
        <IconButton icon="close" label={t('Discard the edits')} onClick={() => playEdits.dismiss()} />
      </header>
      <ul>
        {changes.map((change) => (
          <ChangeLine key={`${keyOf(change)}`} change={change} />
        ))}
      </ul>
      {others.length > 0 && (
        <p>
          {t('Kept only with all edits:')} {others.slice(0, 4).join(', ')}
          {others.length > 4 && t(' and {count} more', { count: others.length - 4 })}
        </p>
      )}
      <footer>
        <Button label={t('Keep none')} onClick={() => playEdits.dismiss()} />
        <Button
          look="primary"
          label={t('Keep all')}
          disabled={changes.length === 0 && !playEdits.canKeepAll}
          onClick={() => editor.attempt(() => playEdits.keepAll())}
        />
      </footer>
    </section>
  );
}

const keyOf = ({ owner, name }: PlayChange): string => `${'id' in owner ? owner.id : 'scene'}.${name}`;

function ChangeLine({ change }: { change: PlayChange }): ReactNode {
  const editor = useEditor();
  const { owner, name, to } = change;
  const { kind } = owner.fields[name];
  const now = owner.getAuthored(name);
  return (
    <li>
      <span className="play-name one-line">{nameOf(change)}</span>
      <span className="play-values">
        {valueText(now, kind)} → <strong>{valueText(to, kind)}</strong>
      </span>
      <Button
        look="small framed"
        label={t('Keep')}
        aria-label={t('Keep {name}', { name: nameOf(change) })}
        disabled={sameValue(now, to)}
        onClick={() => editor.attempt(() => editor.document.playEdits.keep(change))}
      />
    </li>
  );
}
