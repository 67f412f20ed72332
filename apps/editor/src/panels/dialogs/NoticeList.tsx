import { t } from '@farol/editing';
import { type ReactNode, useEffect, useState } from 'react';
import type { Notice } from '../../model/Notices';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';

/** Display times (ms): of a message, of an error, and the addition for each letter. */
const SHOWN = 4000;
const ERROR = 10_000;
const READ = 70;

/** Notices in a lower corner of the viewport. They stay while one is hovered or focused. */
export function NoticeList(): ReactNode {
  const { notices } = useEditor();
  useSignal(notices.changed);
  const [isRead, setIsRead] = useState(false);
  return (
    <div
      className="notices"
      role="status"
      aria-live="polite"
      onPointerEnter={() => setIsRead(true)}
      onPointerLeave={() => setIsRead(false)}
      onFocus={() => setIsRead(true)}
      onBlur={() => setIsRead(false)}
    >
      {notices.current.map((notice) => (
        <NoticeItem key={notice.id} notice={notice} isRead={isRead} onClose={() => notices.remove(notice.id)} />
      ))}
    </div>
  );
}

function NoticeItem({ notice, isRead, onClose }: { notice: Notice; isRead: boolean; onClose(): void }): ReactNode {
  const { id, kind, text, count, lasts } = notice;
  useEffect(() => {
    if (lasts || isRead) return;
    const timer = setTimeout(onClose, Math.max(kind === 'error' ? ERROR : SHOWN, text.length * READ));
    return () => clearTimeout(timer);
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- restarts when repeated or hovered
  }, [id, kind, count, lasts, isRead]);
  return (
    <div className={`notice ${kind}`}>
      <Icon name={kind === 'info' ? 'check' : 'warning'} />
      <span className="notice-text">{text}</span>
      {count > 1 && <span className="notice-count">×{count}</span>}
      <button type="button" className="button small" aria-label={t('Close message')} onClick={onClose}>
        <Icon name="close" size={12} />
      </button>
    </div>
  );
}
