import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useState } from 'react';
import { describeSession } from '../../files/autosave/describeSession';
import type { RecoverDialog as RecoverRequest } from '../../model/Dialogs';
import { useEditor } from '../../ui/EditorContext';

/** What tabs that were closed without warning have left; each can be brought back, or thrown away. */
export function RecoverDialog({ request, onClose }: { request: RecoverRequest; onClose(): void }): ReactNode {
  const editor = useEditor();
  const [sessions, setSessions] = useState(request.sessions);
  return (
    <>
      <Dialog.Title>{t('Unsaved work was found')}</Dialog.Title>
      <Dialog.Description>{t('The editor was closed before these scenes were saved.')}</Dialog.Description>
      <ul className="sessions">
        {sessions.map((session) => (
          <li key={session.id}>
            <span className="session-name" id={`session-${session.id}`}>
              {session.name}
              <span className="session-time">{describeSession(session)}</span>
            </span>
            <button
              type="button"
              className="button framed"
              aria-describedby={`session-${session.id}`}
              onClick={() =>
                editor.attempt(async () => {
                  await request.discard(session);
                  const left = sessions.filter((each) => each !== session);
                  setSessions(left);
                  if (left.length === 0) onClose();
                })
              }
            >
              {t('Discard')}
            </button>
            <button
              type="button"
              className="button primary"
              aria-describedby={`session-${session.id}`}
              onClick={() => {
                onClose();
                editor.attempt(() => request.recover(session));
              }}
            >
              {t('Recover')}
            </button>
          </li>
        ))}
      </ul>
      <div className="dialog-buttons">
        <span className="dialog-hint">
          {t('What is left for later stays: “Recover…” in the menu File offers it again.')}
        </span>
        <button type="button" className="button framed" onClick={onClose}>
          {t('Later')}
        </button>
      </div>
    </>
  );
}
