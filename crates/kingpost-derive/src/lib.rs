//! `#[fields]`: declares a type of the scenario file and generates its reader, its writer, its JSON Schema and its
//! conversion to other scalars.
//!
//! A type of the file is generic over the scalar of its continuous numbers, `struct Rope<S = f64>`, or has no
//! continuous numbers, `struct Pulse`.

mod kinds;
mod naming;
mod over;
mod reader;
mod writer;

use proc_macro::TokenStream;
use proc_macro2::TokenStream as Tokens;
use quote::quote;
use syn::parse::Parser;
use syn::{
    Attribute, Data, DeriveInput, Error, Field, Fields, GenericParam, Ident, Result, Type, Variant, parse_macro_input,
};

use naming::{SerdeNames, name_in_files};

/// Declares a type of the scenario file.
///
/// - The type is read from the tree of a file (`FromNode`), which refuses unknown fields, is written to one (`ToValue`), and has a
///   JSON Schema (feature `schema`). The variants of an enum are written in snake case.
/// - An `Option` field may be omitted, and is not written if it is `None`; with `#[not_null]`, null is refused.
/// - A field with `#[placed(Point)]` or `#[placed(Station)]` is a place in the world, which the mounting of a part
///   moves (`PlaceKind`).
/// - Other fields have the defaults of serde's attributes.
/// - A unit at the end of a field's name has its SI capitals in a file: `force_n` is `force_N`.
/// - A type over scalars `S` is converted from plain numbers to other scalars, number by number (`OverScalar`).
///
/// `#[fields(default)]` takes omitted fields from the type's `Default`. For an enum of kinds, `#[fields(assembled)]`
/// lets each kind assemble its elements (`Assemble`), and `#[fields(sets_inputs)]` lets each kind state the inputs that
/// it sets (`SetsInputs`).
#[proc_macro_attribute]
pub fn fields(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let item = parse_macro_input!(item as DeriveInput);
    declared(arguments.into(), item).unwrap_or_else(Error::into_compile_error).into()
}

fn declared(arguments: Tokens, mut item: DeriveInput) -> Result<Tokens> {
    let Arguments { default: all_default, assembled, sets_inputs } = Arguments::of(arguments)?;
    let over_scalars = item.generics.params.iter().any(|parameter| matches!(parameter, GenericParam::Type(_)));
    match &mut item.data {
        Data::Struct(data) => data.fields.iter_mut().try_for_each(|field| declare_field(field, all_default))?,
        Data::Enum(data) => data.variants.iter().try_for_each(check_kind)?,
        Data::Union(_) => return Err(Error::new_spanned(&item.ident, "a struct or an enum")),
    }
    let attributes = attributes_of(&item, all_default, over_scalars);
    let conversion = over_scalars.then(|| over::conversion(&item)).transpose()?;
    let reader = reader::reader(&item, all_default)?;
    let writer = writer::writer(&item)?;
    let assembly = assembled.then(|| kinds::assembly(&item));
    let inputs = sets_inputs.then(|| kinds::inputs(&item));
    leave_to_schema(&mut item);
    Ok(quote! {
        #attributes
        #item
        #conversion
        #reader
        #writer
        #assembly
        #inputs
    })
}

/// Checks that a variant is a unit variant, or a tuple variant with one field.
fn check_kind(variant: &Variant) -> Result<()> {
    match &variant.fields {
        Fields::Unit => Ok(()),
        Fields::Unnamed(fields) if fields.unnamed.len() == 1 => Ok(()),
        _ => Err(Error::new_spanned(
            variant,
            "expected a unit variant or a tuple variant with one field, as `Rope(Rope<S>)`",
        )),
    }
}

/// Removes the attributes of this crate, and keeps serde's attributes only for the JSON Schema, which reads them too.
fn leave_to_schema(item: &mut DeriveInput) {
    let Data::Struct(data) = &mut item.data else { return };
    for field in &mut data.fields {
        field.attrs.retain(|attribute| !["not_null", "placed"].iter().any(|own| attribute.path().is_ident(own)));
        for attribute in field.attrs.iter_mut().filter(|attribute| attribute.path().is_ident("serde")) {
            let stated = &attribute.meta;
            *attribute = syn::parse_quote!(#[cfg_attr(feature = "schema", #stated)]);
        }
    }
}

/// Arguments of `#[fields]`.
#[derive(Default)]
struct Arguments {
    /// Whether omitted fields take the values of the type's `Default`.
    default: bool,
    /// Whether each kind assembles its elements.
    assembled: bool,
    /// Whether each kind states the inputs that it sets.
    sets_inputs: bool,
}

impl Arguments {
    fn of(arguments: Tokens) -> Result<Self> {
        let mut found = Self::default();
        let parser = syn::meta::parser(|meta| {
            let flag = match meta.path.get_ident().map(ToString::to_string).as_deref() {
                Some("default") => &mut found.default,
                Some("assembled") => &mut found.assembled,
                Some("sets_inputs") => &mut found.sets_inputs,
                _ => return Err(meta.error("`default`, `assembled`, `sets_inputs`, or nothing")),
            };
            *flag = true;
            Ok(())
        });
        parser.parse2(arguments)?;
        Ok(found)
    }
}

fn attributes_of(item: &DeriveInput, all_default: bool, over_scalars: bool) -> Tokens {
    let shape = match item.data {
        Data::Enum(_) => quote!(rename_all = "snake_case",),
        _ if all_default => quote!(deny_unknown_fields, default,),
        _ => quote!(deny_unknown_fields,),
    };
    let name = item.ident.to_string();
    let schema = over_scalars
        .then(|| quote!(#[cfg_attr(feature = "schema", schemars(rename = #name, bound = "S: crate::scenario::leaf::Described"))]));
    quote! {
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema), serde(#shape))]
        #schema
    }
}

/// Adds the serde attributes that follow from a field's name and type.
fn declare_field(field: &mut Field, all_default: bool) -> Result<()> {
    let Some(name) = &field.ident else { return Ok(()) };
    let stated = SerdeNames::of(&field.attrs)?;
    let mut added: Vec<Tokens> = Vec::new();
    let in_files = name_in_files(&name.to_string());
    if stated.rename.is_none() && *name != in_files {
        added.push(quote!(rename = #in_files));
    }
    if is_option(&field.ty) && stated.skip_if.is_none() && !stated.absent {
        if !all_default {
            added.push(quote!(default));
        }
        added.push(quote!(skip_serializing_if = "Option::is_none"));
    }
    if !added.is_empty() {
        let attribute: Attribute = syn::parse_quote!(#[serde(#(#added),*)]);
        field.attrs.push(attribute);
    }
    Ok(())
}

fn is_option(kind: &Type) -> bool {
    matches!(kind, Type::Path(kind) if kind.path.segments.last().is_some_and(|last| last.ident == "Option"))
}

/// Whether the tokens of a type contain the scalar's name.
fn names_scalar(tokens: Tokens, scalar: &Ident) -> bool {
    tokens.into_iter().any(|token| match token {
        proc_macro2::TokenTree::Ident(ident) => ident == *scalar,
        proc_macro2::TokenTree::Group(group) => names_scalar(group.stream(), scalar),
        _ => false,
    })
}
