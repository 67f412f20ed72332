import { t } from '@farol/editing';
import { type ReactNode, useEffect } from 'react';
import type { Notice } from '../../model/Notices';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';

/** How long a message that is no error stays (ms): a short one, and each letter. */
const SHOWN = 4000;
const READ = 70;

/** Messages over the picture. Errors stay until they are closed. */
export function NoticeList(): ReactNode {
  const { notices } = useEditor();
  useSignal(notices.changed);
  return (
    <div className="notices" role="status" aria-live="polite">
      {notices.current.map((notice) => (
        <NoticeItem key={notice.id} notice={notice} onClose={() => notices.remove(notice.id)} />
      ))}
    </div>
  );
}

function NoticeItem({ notice, onClose }: { notice: Notice; onClose(): void }): ReactNode {
  const { id, kind, text } = notice;
  useEffect(() => {
    if (kind === 'error') return;
    const timer = setTimeout(onClose, Math.max(SHOWN, text.length * READ));
    return () => clearTimeout(timer);
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- one time for each message
  }, [id, kind]);
  return (
    <div className={`notice ${kind}`}>
      <Icon name={kind === 'info' ? 'check' : 'warning'} />
      <span>{text}</span>
      <button type="button" className="button small" aria-label={t('Close message')} onClick={onClose}>
        <Icon name="close" size={12} />
      </button>
    </div>
  );
}
