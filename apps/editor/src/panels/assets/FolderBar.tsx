import { t } from '@farol/editing';
import { Fragment, type ReactNode } from 'react';
import { splitName } from '../../model/assetNames';
import { FolderTarget } from './FolderTarget';

/** Path of the open folder as buttons; assets can be dropped on each ancestor. */
export function FolderBar({ folder, onOpen }: { folder: string; onOpen(folder: string): void }): ReactNode {
  const parts = folder === '' ? [] : folder.split('/');
  return (
    <nav className="folder-bar" aria-label={t('Folder')}>
      <FolderTarget folder="" className="link" onOpen={onOpen}>
        {t('Assets')}
      </FolderTarget>
      {parts.map((part, i) => {
        const path = parts.slice(0, i + 1).join('/');
        return (
          <Fragment key={path}>
            <span aria-hidden="true">/</span>
            {path === folder ? (
              <span aria-current="page">{splitName(path).leaf}</span>
            ) : (
              <FolderTarget folder={path} className="link" onOpen={onOpen}>
                {part}
              </FolderTarget>
            )}
          </Fragment>
        );
      })}
    </nav>
  );
}
