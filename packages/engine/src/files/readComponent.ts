import { shortText } from '@farol/editing';
import { checkFieldValue, describeValue, type FieldTable, type FieldValue, isFieldValue } from '@farol/editing/fields';
import { scriptClasses } from '../core/scriptClasses';
import type { ComponentClass } from '../core/ComponentClass';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { FileComponent } from './FarolFile';
import type { PathLike } from './FilePath';
import { isRecord, join, type JsonRecord, type ProblemList } from './ProblemList';

/** Reads field values: only those that a table declares, with checks of kind and range. */
export function readValues(
  value: unknown,
  fields: FieldTable,
  path: PathLike,
  problems: ProblemList,
): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  const given = problems.record(value, path);
  for (const name of Object.keys(given)) {
    const each = given[name];
    const known = Object.hasOwn(fields, name);
    const problem = known
      ? checkFieldValue(fields[name], each)
      : `is unknown; the fields are ${Object.keys(fields).join(', ')}. Remove it.`;
    if (problem) problems.add(join(path, name), problem);
    else values[name] = each as FieldValue;
  }
  return values;
}

/** Migrates values of an older version of the component; null, and a problem, when that fails. */
function migrate(type: ComponentClass, record: JsonRecord, path: PathLike, problems: ProblemList): unknown {
  const values = problems.record(record.values, join(path, 'values'));
  const at = join(path, 'version');
  const version = readVersion(record.version, at, problems);
  if (version === null) return null;
  if (version === type.version) return values;
  if (version > type.version) {
    problems.add(
      at,
      `is ${version}, but this Farol knows ${type.typeName} up to version ${type.version}: update Farol.`,
    );
    return null;
  }
  if (!type.migrate) {
    problems.add(at, `is ${version}, and ${type.typeName} has no migration to version ${type.version}: give it one.`);
    return null;
  }
  try {
    return type.migrate({ ...values }, version);
  } catch (error) {
    problems.add(
      at,
      `is ${version}, and its migration to version ${type.version} failed: ${shortText(String(error), 200)}`,
    );
    return null;
  }
}

/** Reads the values of an unknown type: any value that a field may have. */
function readUnknownValues(value: unknown, path: PathLike, problems: ProblemList): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const [name, each] of Object.entries(problems.record(value, path))) {
    if (name in Object.prototype) problems.add(join(path, name), 'is not a name that a field can have. Remove it.');
    else if (isFieldValue(each)) values[name] = each;
    else
      problems.add(
        join(path, name),
        `must be a number, text, true, false, null or [x, y, z], not ${describeValue(each)}.`,
      );
  }
  return values;
}

/** Reads the values that fit the fields of a script's class; the script may have changed since they were written. */
function readFittingValues(
  value: unknown,
  fields: FieldTable,
  path: PathLike,
  problems: ProblemList,
): Record<string, FieldValue> {
  const fits = ([name, each]: [string, FieldValue]): boolean =>
    Object.hasOwn(fields, name) && checkFieldValue(fields[name], each) === null;
  return Object.fromEntries(Object.entries(readUnknownValues(value, path, problems)).filter(fits));
}

/** Version of the component's class that wrote the values; null, and a problem, when invalid. */
function readVersion(version: unknown, path: PathLike, problems: ProblemList): number | null {
  if (typeof version === 'number' && Number.isInteger(version) && version >= 1) return version;
  problems.add(path, `must be a whole number of at least 1, not ${describeValue(version)}.`);
  return null;
}

const componentKeys = ['type', 'version', 'id', 'enabled', 'values'];

/** Reads a component of a scene file. Returns null and adds to `problems` if it cannot be read. */
export function readComponent(
  value: unknown,
  path: PathLike,
  registry: ComponentRegistry,
  problems: ProblemList,
): FileComponent | null {
  if (!isRecord(value)) {
    problems.record(value, path);
    return null;
  }
  problems.onlyKeys(value, path, componentKeys);
  const typeName = problems.text(value.type, join(path, 'type'));
  const type = registry.types.get(typeName);
  if (!type && typeName && registry.keepsUnknown) {
    const id = problems.text(value.id, join(path, 'id'));
    const enabled = problems.flag(value.enabled, join(path, 'enabled'), true);
    const version = readVersion(value.version, join(path, 'version'), problems);
    const values = readUnknownValues(value.values, join(path, 'values'), problems);
    return version === null ? null : { type: typeName, version, id, ...(enabled ? {} : { enabled }), values };
  }
  if (!type) {
    const known = [...registry.types.keys()].join(', ');
    if (typeName)
      problems.add(
        join(path, 'type'),
        `names the unknown component '${shortText(typeName)}' (known: ${known}): register its class.`,
      );
    return null;
  }
  const id = problems.text(value.id, join(path, 'id'));
  const enabled = problems.flag(value.enabled, join(path, 'enabled'), true);
  const upToDate = migrate(type, value, path, problems);
  if (upToDate === null) return null;
  const at = join(path, 'values');
  const values = scriptClasses.has(type)
    ? readFittingValues(upToDate, type.fields, at, problems)
    : readValues(upToDate, type.fields, at, problems);
  return { type: typeName, version: type.version, id, ...(enabled ? {} : { enabled }), values };
}
