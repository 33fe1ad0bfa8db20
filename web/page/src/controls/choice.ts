/** What every control for one of a few choices is given. */
export interface Choice<Value extends string> {
  label: string;
  value: Value;
  options: readonly { value: Value; label: string }[];
  labelHidden?: boolean;
  onchange: (value: Value) => void;
}
