import { t } from '@farol/editing';
import { Popover } from '@base-ui/react/popover';
import { type ReactNode, type SyntheticEvent, useState } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { Button } from '../../ui/Button';

/** Button that asks for a name, and adds a microshader to the scene. */
export function NewChunk({ onMade }: { onMade(name: string): void }): ReactNode {
  const { microShaders } = useEditor();
  const [isOpen, setOpen] = useState(false);
  const [name, setName] = useState('');
  const [problem, setProblem] = useState('');
  const make = (event: SyntheticEvent): void => {
    event.preventDefault();
    try {
      microShaders.create(name.trim());
      setOpen(false);
      onMade(name.trim());
    } catch (error) {
      setProblem((error as Error).message);
    }
  };
  return (
    <Popover.Root
      open={isOpen}
      onOpenChange={(open) => {
        setOpen(open);
        setName('');
        setProblem('');
      }}
    >
      <Popover.Trigger className="button small" aria-label={t('New microshader')} title={t('New microshader')}>
        <Icon name="add" size={13} />
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Positioner className="positioner" sideOffset={4} align="start">
          <Popover.Popup className="popup new-chunk" aria-label={t('New microshader')}>
            <form onSubmit={make}>
              <input
                className="input"
                aria-label={t('Name of the microshader')}
                aria-invalid={problem !== ''}
                placeholder={t('Name, such as own/tint')}
                autoComplete="off"
                spellCheck={false}
                value={name}
                onChange={(event) => {
                  setName(event.target.value);
                  setProblem('');
                }}
              />
              <Button look="primary" label={t('Make')} type="submit" disabled={name.trim() === ''} />
            </form>
            {problem && (
              <p role="alert" className="chunk-problem">
                {problem}
              </p>
            )}
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
