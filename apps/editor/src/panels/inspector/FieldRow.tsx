import { describeField, FieldGesture, type FieldUpdate, labelOfField, t } from '@farol/editing';
import type { Field, FieldOwner, FieldValue } from '@farol/engine/fields';
import { type ComponentType, memo, type ReactNode, useCallback, useMemo } from 'react';
import type { OwnerFieldProps } from '../../api/FieldEditorProps';
import { fieldEditors, numberEditors } from '../../fields';
import { resetFields } from '../../model/edits';
import { ownersName } from '../../model/ownersName';
import { OverrideMark } from '../prefab/OverrideMark';
import { useEditor } from '../../ui/EditorContext';
import { useIsFound } from '../../ui/FieldFilter';
import { IconButton } from '../../ui/IconButton';

interface FieldRowProps {
  /** Edited components or settings of one type; memoised. */
  readonly owners: readonly FieldOwner[];
  readonly name: string;
  readonly field: Field;
  /** Common value of the owners; null when their values differ. */
  readonly value: FieldValue;
  readonly mixed: boolean;
  /** Coordinates of a vector that are equal in all owners, as JSON; others are null. */
  readonly parts: string;
  /** Whether all owners have the default value. */
  readonly isDefault: boolean;
  /** Elements that show simulated values, by field; each row adds its own. */
  readonly places: Map<string, HTMLElement>;
  /** Choices of a text field, one per line; null when it takes any text. */
  readonly choices: string | null;
}

/** Label and editor of a field. Dragging, typing or choosing a value is one step of history. */
export const FieldRow = memo(function FieldRow(props: FieldRowProps): ReactNode {
  const { owners, name, field, value, mixed, parts, isDefault, places, choices } = props;
  const editor = useEditor();
  const gesture = useMemo(
    () => new FieldGesture(editor.commands, owners, name, () => ownersName(owners)),
    [editor, owners, name],
  );
  // each kind has its own editor, as the table's type ensures; TypeScript cannot infer that from a union
  const Editor = (field.kind === 'number' && field.input
    ? numberEditors[field.input]
    : fieldEditors[field.kind]) as unknown as ComponentType<OwnerFieldProps<Field>>;
  const label = labelOfField(name, field);
  const description = describeField(field);
  const place = useCallback(
    (element: HTMLElement | null) => {
      if (element) places.set(name, element);
      else places.delete(name);
    },
    [places, name],
  );
  const reset = (): void => {
    const step = t('Reset {field} of {name}', { field: label.toLowerCase(), name: ownersName(owners) });
    editor.commands.run(resetFields(step, owners, [name]));
  };
  const isFound = useIsFound(label, name);
  if (!isFound) return null;
  return (
    <div className={`field field-${field.kind}`} data-field={name} data-help={description}>
      <span className="field-label" title={description}>
        <span className="field-name">{label}</span>
        {!isDefault && !field.readOnly && (
          <IconButton
            icon="undo"
            size={11}
            className="field-reset"
            label={t('Reset to default')}
            aria-description={label}
            title={t('Reset {label} to its default', { label })}
            onClick={() => editor.attempt(reset)}
          />
        )}
        <OverrideMark owners={owners} name={name} label={label} />
      </span>
      <div className="field-editor">
        <Editor
          owners={owners}
          field={field}
          name={name}
          value={value as never}
          mixed={mixed}
          parts={parts ? (JSON.parse(parts) as (number | null)[]) : undefined}
          choices={choices === null ? undefined : choices.split('\n').filter(Boolean)}
          label={label}
          description={description}
          disabled={field.readOnly ?? false}
          onPreview={(update) => editor.attempt(() => gesture.preview(update as FieldUpdate))}
          onCommit={(update) => editor.attempt(() => gesture.commit(update as FieldUpdate))}
          onAmend={(update) => editor.attempt(() => gesture.amend(update as FieldUpdate))}
          onDiscard={() => gesture.discard()}
        />
        <span ref={place} className="live" hidden />
      </div>
    </div>
  );
});
