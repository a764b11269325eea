// Price of a garment, by the fabric it is cut from; the page and the server use the same rule.

/** Fabric is sold in steps of this length. */
export const stepCm = 5;
export const centsPerMetre = 3400;
/** Tolerance of lengths. [cm] */
const slack = 0.01;

/** Metres to buy for a length in centimetres. */
export const metresFor = (lengthCm) => (Math.ceil((lengthCm - slack) / stepCm) * stepCm) / 100;

export const centsFor = (lengthCm) => Math.round(metresFor(lengthCm) * centsPerMetre);

const euros = new Intl.NumberFormat('en-IE', {style: 'currency', currency: 'EUR'});
export const money = (cents) => euros.format(cents / 100);
