import { t } from '@farol/editing';
import { type ReactNode, useEffect, useRef } from 'react';
import { forgetRecent, openRecent } from '../../files/recent/openRecent';
import type { RecentFile } from '../../model/RecentFiles';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';

const when = new Intl.DateTimeFormat(undefined, { dateStyle: 'medium', timeStyle: 'short' });

/** Recent files with thumbnails; nothing when there are none. */
export function RecentCards({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const { recentFiles } = editor;
  useSignal(recentFiles.changed);
  if (recentFiles.list.length === 0) return null;
  return (
    <section aria-label={t('Recent files')}>
      <h3>{t('Recent files')}</h3>
      <ul className="welcome-cards">
        {recentFiles.list.map((file) => (
          <li key={file.id}>
            <button
              type="button"
              className="welcome-card"
              title={t('Opened or saved {time}', { time: when.format(file.time) })}
              onClick={() => {
                onClose();
                editor.attempt(() => openRecent(editor, file));
              }}
            >
              <Picture file={file} />
              <span>{file.name}</span>
            </button>
            <IconButton
              icon="close"
              className="button small welcome-forget"
              label={t('Forget {name}', { name: file.name })}
              title={t('Take it out of this list; the file stays')}
              onClick={() => editor.attempt(() => forgetRecent(editor, file))}
            />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Picture({ file: { picture } }: { file: RecentFile }): ReactNode {
  const image = useRef<HTMLImageElement>(null);
  useEffect(() => {
    if (!picture || !image.current) return;
    const url = URL.createObjectURL(picture);
    image.current.src = url;
    return () => URL.revokeObjectURL(url);
  }, [picture]);
  if (picture) return <img ref={image} alt="" width="240" height="135" />;
  return (
    <span className="welcome-picture">
      <Icon name="scene" size={26} />
    </span>
  );
}
