//! Reads a type from a node of a file's tree.

use proc_macro2::TokenStream as Tokens;
use quote::{format_ident, quote};
use syn::{Data, DeriveInput, Error, Field, Fields, Ident, Path, Result, Type};

use crate::naming::{SerdeNames, snake_case};

/// Returns the implementation of `FromNode`; if `all_default`, omitted fields have the values of the type's `Default`.
pub fn reader(item: &DeriveInput, all_default: bool) -> Result<Tokens> {
    let name = &item.ident;
    let scalar = item.generics.type_params().next().map(|parameter| {
        let scalar = &parameter.ident;
        quote!(type #scalar = f64;)
    });
    let (body, allowed, declared) = match &item.data {
        Data::Struct(data) => {
            let read = |(k, field)| read_field(k, field);
            let fields: Vec<Read<'_>> = data.fields.iter().enumerate().map(read).collect::<Result<_>>()?;
            let in_files = fields.iter().filter(|field| !field.stated.absent);
            let declared = declared(in_files.map(|field| (field.name(), field.of, field.placed.as_ref())), &scalar);
            let body = of_fields(&fields, all_default);
            (body, quote!(crate::scenario::wording::FIELDS.to_owned()), declared)
        }
        Data::Enum(data) => {
            let kinds: Vec<String> =
                data.variants.iter().map(|variant| snake_case(&variant.ident.to_string())).collect();
            let arms = data.variants.iter().zip(&kinds);
            let arms = arms.map(|(variant, kind)| arm(&variant.ident, kind, !matches!(variant.fields, Fields::Unit)));
            let body = quote! {
                let (kind, of) = reading::kind(node, &[#(#kinds),*])?;
                match kind {
                    #(#arms)*
                    _ => Err(reading::ReadFault::at(node, Self::allowed())),
                }
            };
            let with_fields = data.variants.iter().zip(&kinds);
            let with_fields =
                with_fields.filter_map(|(variant, kind)| Some((kind.clone(), &variant.fields.iter().next()?.ty, None)));
            let declared = declared(with_fields, &scalar);
            (body, quote!(crate::scenario::wording::one_of(&[#(#kinds),*])), declared)
        }
        Data::Union(_) => return Err(Error::new_spanned(name, "a struct or an enum")),
    };
    Ok(quote! {
        impl crate::scenario::reading::FromNode for #name {
            #declared
            fn read(node: &crate::scenario::tree::ScenarioNode) -> Result<Self, crate::scenario::reading::ReadFault> {
                use crate::scenario::reading;
                #scalar
                #body
            }
            fn allowed() -> String {
                #allowed
            }
        }
    })
}

/// Returns the table of the fields in files, or of the kinds with fields, each with its type and its kind of place.
fn declared<'a>(fields: impl Iterator<Item = (String, &'a Type, Option<&'a Path>)>, scalar: &Option<Tokens>) -> Tokens {
    let declared = fields.map(|(name, of, placed)| {
        let placed = match placed {
            Some(place) => quote!(Some(crate::scenario::reading::PlaceKind::#place)),
            None => quote!(None),
        };
        quote!(crate::scenario::reading::DeclaredField::of::<#of>(#name, #placed))
    });
    quote! {
        fn declared_fields() -> &'static [crate::scenario::reading::DeclaredField] {
            #scalar
            const DECLARED_FIELDS: &[crate::scenario::reading::DeclaredField] = &[#(#declared),*];
            DECLARED_FIELDS
        }
    }
}

fn arm(variant: &Ident, kind: &str, has_fields: bool) -> Tokens {
    if has_fields {
        quote!(#kind => reading::kind_with_fields(node, kind, of).map(Self::#variant),)
    } else {
        quote!(#kind => reading::kind_without_fields(node, kind, of).map(|()| Self::#variant),)
    }
}

/// A field to read.
struct Read<'a> {
    ident: &'a Ident,
    of: &'a Type,
    slot: Ident,
    stated: SerdeNames,
    not_null: bool,
    /// Its kind of place in the world.
    placed: Option<Path>,
}

fn of_fields(fields: &[Read<'_>], all_default: bool) -> Tokens {
    let in_files = || fields.iter().filter(|field| !field.stated.absent);
    let slots = in_files().map(|field| &field.slot);
    let arms = in_files().map(|field| {
        let (name, slot) = (field.name(), &field.slot);
        let read = if field.not_null { quote!(present) } else { quote!(field) };
        quote!(#name => #slot = Some(reading::#read(name, of)?),)
    });
    let made = fields.iter().map(|field| field.made(all_default));
    let whole = all_default.then(|| quote!(let whole = Self::default();));
    quote! {
        #(let mut #slots = None;)*
        for (name, of) in reading::fields(node)? {
            match name.as_str() {
                #(#arms)*
                _ => return Err(reading::unknown(name, of, Self::declared_fields())),
            }
        }
        #whole
        Ok(Self { #(#made),* })
    }
}

fn read_field(k: usize, field: &Field) -> Result<Read<'_>> {
    let ident = field.ident.as_ref().ok_or_else(|| Error::new_spanned(field, "a field with a name"))?;
    let not_null = field.attrs.iter().any(|attribute| attribute.path().is_ident("not_null"));
    let placed = field.attrs.iter().find(|attribute| attribute.path().is_ident("placed"));
    let placed = placed.map(|attribute| attribute.parse_args()).transpose()?;
    let stated = SerdeNames::of(&field.attrs)?;
    Ok(Read { ident, of: &field.ty, slot: format_ident!("field_{k}"), stated, not_null, placed })
}

impl Read<'_> {
    fn name(&self) -> String {
        self.stated.in_files(self.ident)
    }

    /// Returns the field's value: from the file, or its default.
    fn made(&self, all_default: bool) -> Tokens {
        let Self { ident, slot, stated, .. } = self;
        let name = self.name();
        match &stated.default {
            _ if stated.absent => quote!(#ident: Default::default()),
            _ if all_default => quote!(#ident: #slot.unwrap_or(whole.#ident)),
            Some(Some(path)) => quote!(#ident: match #slot { Some(read) => read, None => #path() }),
            Some(None) => quote!(#ident: #slot.unwrap_or_default()),
            _ => quote!(#ident: reading::or_absent(#slot, #name, node)?),
        }
    }
}
