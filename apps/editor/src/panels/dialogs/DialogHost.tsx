import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ComponentType, lazy, type ReactNode, type RefObject, Suspense, useEffect, useRef, useState } from 'react';
import { readableText } from '../../model/readableText';
import type { ConfirmDialog, DialogRequest, PlainDialog } from '../../model/Dialogs';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './dialogs.css';
import { Button } from '../../ui/Button';

const RecoverDialog = lazy(async () => ({ default: (await import('./RecoverDialog')).RecoverDialog }));
const Welcome = lazy(async () => ({ default: (await import('../welcome/Welcome')).Welcome }));
const TextDialog = lazy(async () => ({ default: (await import('./TextDialog')).TextDialog }));
const ProgressDialog = lazy(async () => ({ default: (await import('./ProgressDialog')).ProgressDialog }));
const AgentBar = lazy(async () => ({ default: (await import('../agent/AgentBar')).AgentBar }));

/** Dialogs without properties, by kind. */
const plain = {
  keys: lazy(async () => ({ default: (await import('../keys/KeysPage')).KeysPage })),
  palette: lazy(async () => ({ default: (await import('../palette/CommandPalette')).CommandPalette })),
  about: lazy(async () => ({ default: (await import('./AboutDialog')).AboutDialog })),
  export: lazy(async () => ({ default: (await import('./ExportDialog')).ExportDialog })),
  agent: lazy(async () => ({ default: (await import('./AgentDialog')).AgentDialog })),
  picture: lazy(async () => ({ default: (await import('./PictureDialog')).PictureDialog })),
  film: lazy(async () => ({ default: (await import('./FilmDialog')).FilmDialog })),
  phone: lazy(async () => ({ default: (await import('./PhoneDialog')).PhoneDialog })),
} satisfies Record<PlainDialog['kind'], ComponentType<{ onClose(): void }>>;

const isPlain = (request: DialogRequest): request is PlainDialog => request.kind in plain;

const shapes: Partial<Record<DialogRequest['kind'], string>> = {
  palette: 'palette',
  keys: 'keys-page',
  welcome: 'welcome-dialog',
};

export function DialogHost(): ReactNode {
  const { dialogs } = useEditor();
  useSignal(dialogs.changed);
  const { current } = dialogs;
  const popup = useRef<HTMLDivElement>(null);
  const [isAgentAsked, setAgentAsked] = useState(false);
  if (current?.kind === 'agent' && !isAgentAsked) setAgentAsked(true);
  // the focus returns before a palette command moves it; Base UI would do it later, without knowing where it was
  useEffect(() => {
    if (!current) (dialogs.before as HTMLElement | null)?.focus();
  }, [current, dialogs]);
  return (
    <>
      <Suspense fallback={null}>{isAgentAsked && <AgentBar />}</Suspense>
      <Dialog.Root open={current !== null} onOpenChange={(open) => !open && dialogs.close(false)}>
        <Dialog.Portal>
          <Dialog.Backdrop className="backdrop" />
          <Dialog.Popup
            ref={popup}
            className={`dialog ${(current && shapes[current.kind]) ?? ''}`}
            finalFocus={() => !dialogs.before?.isConnected}
          >
            <Suspense
              fallback={
                current?.kind === 'palette' && (
                  <input
                    className="input"
                    aria-label={t('Search commands')}
                    ref={(input) => input?.focus()}
                    onChange={({ target }) => (dialogs.typed = target.value)}
                  />
                )
              }
            >
              {current && (
                <>
                  <Content request={current} onClose={(agreed) => dialogs.close(agreed)} />
                  <FocusField popup={popup} />
                </>
              )}
            </Suspense>
          </Dialog.Popup>
        </Dialog.Portal>
      </Dialog.Root>
    </>
  );
}

/** Focuses the first field of a dialog whose content was fetched after it opened. */
function FocusField({ popup }: { popup: RefObject<HTMLElement | null> }): null {
  useEffect(() => {
    const { activeElement } = document;
    const isInside = activeElement !== popup.current && popup.current?.contains(activeElement);
    if (!isInside) popup.current?.querySelector<HTMLElement>('.input, .palette-input, textarea')?.focus();
  }, [popup]);
  return null;
}

function Content({ request, onClose }: { request: DialogRequest; onClose(agreed: boolean): void }): ReactNode {
  if (isPlain(request)) {
    const Plain = plain[request.kind];
    return <Plain onClose={() => onClose(false)} />;
  }
  if (request.kind === 'recover') return <RecoverDialog request={request} onClose={() => onClose(false)} />;
  if (request.kind === 'welcome') return <Welcome request={request} onClose={() => onClose(false)} />;
  if (request.kind === 'text') return <TextDialog request={request} onClose={() => onClose(false)} />;
  if (request.kind === 'progress') return <ProgressDialog request={request} onClose={() => onClose(false)} />;
  return (
    <>
      <Dialog.Title>{readableText(request.title)}</Dialog.Title>
      <Dialog.Description>{readableText(request.text)}</Dialog.Description>
      {request.kind === 'problems' && (
        // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a scrolling list must be reachable by keyboard
        <ul
          className="problems"
          tabIndex={0}
          aria-label={request.listLabel ?? (request.action ? t('Uses') : t('Problems'))}
        >
          {request.problems.map(({ path, problem }, i) => (
            // oxlint-disable-next-line react/no-array-index-key -- two objects may have the same name
            <li key={i}>
              {path && <code>{readableText(path)}</code>} {readableText(problem)}
            </li>
          ))}
        </ul>
      )}
      <Buttons
        action={request.action}
        refusal={request.kind === 'problems' ? request.refusal : undefined}
        other={request.kind === 'confirm' ? request.other : undefined}
        onClose={onClose}
      />
    </>
  );
}

interface ButtonsProps {
  readonly action?: string;
  readonly refusal?: string;
  readonly other?: ConfirmDialog['other'];
  onClose(agreed: boolean): void;
}

function Buttons({ action, refusal = t('Cancel'), other, onClose }: ButtonsProps): ReactNode {
  return (
    <div className="dialog-buttons">
      <Button label={action ? refusal : t('Close')} onClick={() => onClose(false)} />
      {other && (
        <Button
          label={other.label}
          onClick={() => {
            other.choose();
            onClose(false);
          }}
        />
      )}
      {action && <Button look="primary" label={action} onClick={() => onClose(true)} />}
    </div>
  );
}
