/** Every text that a person reads, by the area of the page that shows it. */
export const en = {};
