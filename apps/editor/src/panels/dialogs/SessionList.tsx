import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { describeSession } from '../../files/autosave/describeSession';
import type { RecoveryOffer } from '../../model/Dialogs';
import { useEditor } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

interface SessionListProps {
  readonly offer: RecoveryOffer;
  /** Closes the dialog that contains the list. */
  onClose(): void;
  /** Called when the last session was discarded. */
  onEmpty(): void;
}

/** Unsaved scenes of closed tabs; each can be recovered or discarded. */
export function SessionList({ offer, onClose, onEmpty }: SessionListProps): ReactNode {
  const editor = useEditor();
  const [sessions, setSessions] = useState(offer.sessions);
  return (
    <ul className="sessions">
      {sessions.map((session) => (
        <li key={session.id}>
          <span className="session-name" id={`session-${session.id}`}>
            {session.name}
            <span className="session-time">{describeSession(session)}</span>
          </span>
          <Button
            label={t('Discard')}
            aria-describedby={`session-${session.id}`}
            onClick={() =>
              editor.attempt(async () => {
                await offer.discard(session);
                const remaining = sessions.filter((each) => each !== session);
                setSessions(remaining);
                if (remaining.length === 0) onEmpty();
              })
            }
          />
          <Button
            look="primary"
            label={t('Recover')}
            aria-describedby={`session-${session.id}`}
            onClick={() => {
              onClose();
              editor.attempt(() => offer.recover(session));
            }}
          />
        </li>
      ))}
    </ul>
  );
}
