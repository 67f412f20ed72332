import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { openExamples } from '../../actions/file';
import { useEditor } from '../../ui/EditorContext';
import { labelOf } from '../../api/Action';

/** URLs of the thumbnails, made by `packages/tools/samplePictures.mjs`. */
const pictures: Readonly<Record<string, string>> = import.meta.glob('./pictures/*.webp', {
  eager: true,
  query: '?url',
  import: 'default',
});

/** Samples, each with a thumbnail and a hint. */
export function SampleCards({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  return (
    <section aria-label={t('Samples')}>
      <h3>{t('Samples')}</h3>
      <ul className="welcome-cards">
        {openExamples.map((action) => {
          const { name, help } = editor.samples[action.id.slice('file.new.'.length)];
          return (
            <li key={action.id}>
              <button
                type="button"
                className="welcome-card"
                onClick={() => {
                  onClose();
                  editor.attempt(() => action.run(editor));
                }}
              >
                <img src={pictures[`./pictures/${name}.webp`]} alt="" width="320" height="180" />
                <span>
                  {labelOf(action, editor)}
                  <span className="welcome-help">{t(help)}</span>
                </span>
              </button>
            </li>
          );
        })}
      </ul>
    </section>
  );
}
