import { namesOf, t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { ReactNode } from 'react';
import { SetProperty } from '../../model/commands/SetProperty';
import { useEditor } from '../../ui/EditorContext';
import { useIsFound } from '../../ui/FieldFilter';
import { TextInput } from '../../ui/TextInput';

const textOf = ({ tags }: GameObject): string => tags.join(', ');

/** Tags of the selected objects: words separated by commas. */
export function TagsField({ objects }: { objects: readonly GameObject[] }): ReactNode {
  const { commands } = useEditor();
  const [first] = objects;
  const isFound = useIsFound(t('Tags'), 'tags');
  const help = t('Words by which scripts and triggers find the object, separated by commas.');
  const commit = (text: string): void => {
    const words = text.split(',').map((word) => word.trim());
    const tags = [...new Set(words.filter((word) => word !== ''))];
    commands.run(new SetProperty(t('Tagged {name}', { name: namesOf(objects) }), objects, 'tags', tags));
  };
  if (!isFound) return null;
  return (
    <div className="field object-tags" data-field="tags" data-help={help}>
      <span className="field-label" title={help}>
        <span className="field-name">{t('Tags')}</span>
      </span>
      <div className="field-editor">
        <TextInput
          value={objects.every((each) => textOf(each) === textOf(first)) ? textOf(first) : null}
          label={t('Tags of the object')}
          description={help}
          onCommit={commit}
        />
      </div>
    </div>
  );
}
