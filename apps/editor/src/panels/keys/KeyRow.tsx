import { t } from '@farol/editing';
import { type KeyboardEvent, type ReactNode, useState } from 'react';
import { type Action, labelOf } from '../../api/Action';
import { combinationOf } from '../../actions/combinationOf';
import { useEditor } from '../../ui/EditorContext';
import { useKeyBindings } from '../../ui/useKeyBindings';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { keyText } from '../../ui/keyText';
import { Button } from '../../ui/Button';

/** An action with its keys, which can be removed; pressing keys adds others. */
export function KeyRow({ action, label }: { action: Action; label: string }): ReactNode {
  const editor = useEditor();
  const [isListening, setListening] = useState(false);
  /** A pressed combination that another action already has; null for none. */
  const [asked, setAsked] = useState<string | null>(null);
  const bindings = useKeyBindings();
  const keys = bindings.keysOf(action);
  const without = (key: string): string[] => keys.filter((other) => other !== key);
  const clashes = keys.flatMap((each) => bindings.conflictsOf(action, each).map((other) => [each, other] as const));
  const others = asked === null ? [] : bindings.conflictsOf(action, asked).map((other) => labelOf(other, editor));

  const keyDown = (event: KeyboardEvent): void => {
    if (!isListening || event.key === 'Tab') return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === 'Escape') return setListening(false);
    const combination = combinationOf(event.nativeEvent);
    if (combination === null) return;
    setListening(false);
    if (bindings.conflictsOf(action, combination).length > 0) setAsked(combination);
    else bindings.take(action, combination);
  };

  return (
    <div className="key-row" data-action={action.id}>
      <span>{label}</span>
      <span className="key-list">
        {keys.map((each) => (
          <kbd key={each}>
            {keyText(each)}
            <button
              type="button"
              aria-label={t('Take {keys} from {label}', { keys: each, label })}
              title={t('Take this key away')}
              onClick={() => bindings.bind(action, without(each))}
            >
              <Icon name="close" size={9} />
            </button>
          </kbd>
        ))}
        <button
          type="button"
          className={`key-add ${isListening ? 'listening' : ''}`}
          aria-label={isListening ? t('Press the keys for {label}', { label }) : t('Add a key for {label}', { label })}
          title={t('Add a key: press it next')}
          onClick={() => {
            setAsked(null);
            setListening(!isListening);
          }}
          onKeyDown={keyDown}
          onBlur={() => setListening(false)}
        >
          {isListening ? t('Press keys…') : <Icon name="add" size={11} />}
        </button>
        {bindings.isRebound(action) && (
          <IconButton
            icon="undo"
            size={11}
            className="key-add"
            label={t('Own keys of {label}', { label })}
            title={t('Back to its own keys')}
            onClick={() => bindings.bind(action, null)}
          />
        )}
      </span>
      {asked !== null && (
        <div className="key-conflict" role="alert">
          <span>{t('{keys} is “{action}”.', { keys: keyText(asked), action: others.join('”, “') })}</span>
          <Button
            look="small framed"
            label={t('Take it over')}
            onClick={() => {
              bindings.take(action, asked);
              setAsked(null);
            }}
          />
          <Button look="small framed" label={t('Leave it')} onClick={() => setAsked(null)} />
        </div>
      )}
      {clashes.length > 0 && (
        <div className="key-conflict">
          <Icon name="warning" size={12} />
          {clashes
            .map(([each, other]) =>
              t('{keys} is “{action}” too', { keys: keyText(each), action: labelOf(other, editor) }),
            )
            .join('; ')}
        </div>
      )}
    </div>
  );
}
