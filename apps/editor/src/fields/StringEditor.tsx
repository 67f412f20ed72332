import { t } from '@farol/editing';
import type { StringField } from '@farol/engine/fields';
import { lazy, type ReactNode, Suspense } from 'react';
import { SearchSelect } from '../ui/SearchSelect';
import { SelectBox, type SelectOption } from '../ui/SelectBox';
import { TextInput } from '../ui/TextInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

const KeyEditor = lazy(async () => ({ default: (await import('./KeyEditor')).KeyEditor }));

/** Number of choices up to which a plain list is shown; longer ones are searched by typing. */
const SHORT = 10;

/** A text field; a list when the owner gives choices; a key field for key codes. */
export function StringEditor(props: FieldEditorProps<StringField>): ReactNode {
  const { field, value, mixed, label, description, disabled, choices, onCommit } = props;
  if (field.input === 'key') {
    return (
      <Suspense fallback={<span className="select" />}>
        <KeyEditor {...{ value: mixed ? null : value, label, description, disabled, onCommit }} />
      </Suspense>
    );
  }
  if (!choices) {
    return <TextInput value={value} label={label} description={description} disabled={disabled} onCommit={onCommit} />;
  }
  const options: SelectOption<string>[] = choices.map((choice) => ({ value: choice, label: choice }));
  if (value && !choices.includes(value)) options.push({ value, label: t('{name} (not there)', { name: value }) });
  if (choices.length > SHORT) {
    return (
      <SearchSelect
        {...{ value: mixed ? null : value || null, options, label, description, disabled }}
        placeholder={mixed ? '—' : t('None')}
        onChange={(next) => onCommit(next ?? '')}
      />
    );
  }
  options.unshift({ value: '', label: t('None') });
  return <SelectBox {...{ value: mixed ? null : value, options, label, description, disabled }} onChange={onCommit} />;
}
