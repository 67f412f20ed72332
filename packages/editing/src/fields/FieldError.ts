import { shortText } from '../shortText';

/** Error for a value that a field does not allow, or for a field that does not exist. */
export class FieldError extends Error {
  /**
   * @param owner - type of the component, such as 'Light'
   * @param field - name of the field
   * @param problem - what is wrong and what is allowed
   */
  constructor(
    readonly owner: string,
    readonly field: string,
    readonly problem: string,
  ) {
    super(`${shortText(owner)}.${shortText(field)} ${shortText(problem, 400)}`);
    this.name = 'FieldError';
  }
}
